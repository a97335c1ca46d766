#!/usr/bin/env bash
# How the headers include each other: downwards, in no circle, and all of them from their umbrella; and
# with what tells the linker how Eigen aligns.
#   bash tests/includes.sh     says every violation and fails
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../include/topobag"
violations=$(mktemp)
trap 'rm -f "$violations"' EXIT

# Each room, and those that it may use directly; what they use it may use too. `root` is for all.
rooms="
types
sensing    types
edges      types
graph      types sensing edges
similarity graph
matching   graph sensing
bag        graph similarity matching
recognition bag
evaluation types sensing
adaptors   recognition evaluation"

mapfile -t headers < <(find . -name '*.hpp' -printf '%P\n' | LC_ALL=C sort)

# includes FILE...: "FILE INCLUDED LINE" for each #include.
includes() {
  awk '/^[ \t]*#[ \t]*include/ {
    included = $0
    sub(/^[^<"]*/, "", included)
    sub(/[>"][^>"]*$/, "", included)
    if (included ~ /^</) included = substr(included, 2)
    print FILENAME, included, FNR
  }' "$@"
}

# Downwards: FILE's room may use INCLUDED's; nothing outside adaptors/ includes an adaptor or needs
# another package than Eigen, but for the Delaunay builders; nothing includes an umbrella.
includes "${headers[@]}" | awk -v rooms="$rooms" -v umbrella='^(core|evaluation|topobag)\\.hpp$' '
  function room(path) { return path ~ /\// ? substr(path, 1, index(path, "/") - 1) : "root" }
  function say(what) { printf "%s:%d: %s\n", $1, $3, what }
  BEGIN {
    n = split(rooms, lines, "\n")
    for (i = 1; i <= n; ++i) {
      if ((m = split(lines[i], names, " ")) == 0) continue
      may[names[1], names[1]] = may[names[1], "root"] = 1
      for (j = 2; j <= m; ++j)
        for (k in seen) if ((names[j], k) in may) may[names[1], k] = 1
      seen[names[1]]
    }
    may["root", "root"] = 1
  }
  $2 ~ /^"/ { say("includes " $2 "\" by quotes: write <topobag/...>") }
  $2 ~ /^(CGAL|opencv2|sqlite3|libpq)/ && $1 !~ /^adaptors\// &&
    $1 !~ /^edges\/(detail\/)?(delaunay|gabriel|relative_neighborhood|minimum_spanning_tree)/ {
    say("needs " $2 ": only Eigen may be needed here")
  }
  sub(/^topobag\//, "", $2) {
    if ($1 ~ umbrella) {
      if ($2 ~ /(^|\/)(detail|adaptors)\//) say("an umbrella brings in " $2)
      if ($2 == "topobag.hpp") say("includes the larger umbrella")
    } else if ($2 ~ umbrella) {
      say("includes the umbrella " $2)
    } else if (!((room($1), room($2)) in may)) {
      say("includes " $2 ": " room($1) "/ may not use " room($2) "/")
    }
  }' >>"$violations"

# In no circle. The second half of a header, detail/x_impl.hpp, is one with x.hpp.
includes "${headers[@]}" | sed -En 's#(detail/)?(\w+)_impl\.hpp#\2.hpp#g; s#^(\S+) topobag/(\S+) .*#\1 \2#p' |
  awk '$1 != $2' | { tsort 2>&1 >/dev/null || true; } | sed 's/^tsort: -: /a circle: /; s/^tsort: /  /' >>"$violations"

# reached FROM...: every header that these include, directly or not, and they themselves.
reached() {
  includes "${headers[@]}" | awk -v from="$*" '
    sub(/^topobag\//, "", $2) { to[$1] = to[$1] " " $2 }
    END {
      for (n = split(from, queue, " "); n > 0;) {
        file = queue[n--]
        if (file in met) continue
        met[file]
        print file
        m = split(to[file], next_files, " ")
        for (i = 1; i <= m; ++i) queue[++n] = next_files[i]
      }
    }' | LC_ALL=C sort
}

# What a program may include has to be found through an umbrella: by name in core.hpp,
# evaluation.hpp or topobag.hpp, or, an adaptor's part, through the adaptor of that name. An adaptor is included by itself. A detail
# that nothing uses is dead.
umbrellas=$(includes core.hpp evaluation.hpp topobag.hpp | sed -En 's#^\S+ topobag/(\S+) .*#\1#p')
adaptors=$(printf '%s\n' "${headers[@]}" | grep -E '^adaptors/[^/]+$')
all=$(reached topobag.hpp evaluation.hpp $adaptors)
for header in "${headers[@]}"; do
  case $header in
    topobag.hpp | core.hpp | evaluation.hpp) continue ;;
    */detail/* | adaptors/*/*) found=$all ;;
    adaptors/*) continue ;;
    *) found=$umbrellas ;;
  esac
  grep -qxF "$header" <<<"$found" || echo "$header: no umbrella brings it in"
done >>"$violations"

# What is laid out as Eigen aligns it reaches the mark by which the linker refuses two alignments.
mark=types/detail/one_alignment.hpp
includes "${headers[@]}" | awk -v mark="$mark" '
  $2 ~ /^Eigen\// { aligned[$1] }
  sub(/^topobag\//, "", $2) { from[$2] = from[$2] " " $1 }
  END {
    reaching[mark]
    queue[n = 1] = mark
    while (n > 0) {
      m = split(from[queue[n--]], next_files, " ")
      for (i = 1; i <= m; ++i)
        if (!(next_files[i] in reaching)) {
          reaching[next_files[i]]
          queue[++n] = next_files[i]
        }
    }
    for (file in aligned) if (!(file in reaching)) print file ": includes Eigen and does not reach " mark
  }' | LC_ALL=C sort >>"$violations"

# These are what needs Eigen alone.
for header in $(reached core.hpp evaluation.hpp); do
  includes "$header" | awk '$2 ~ /^(CGAL|opencv2|sqlite3|libpq)/ { print "core.hpp or evaluation.hpp reaches " $1 ", which needs " $2 }'
done >>"$violations"

# A program names no detail.
grep -rnE 'include <topobag/(.*/)?detail/|topobag::detail::' ../../examples --include='*.[ch]pp' \
  >>"$violations" || true

if [ -s "$violations" ]; then
  cat "$violations"
  exit 1
fi
echo "${#headers[@]} headers include each other as they should"
