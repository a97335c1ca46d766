#!/usr/bin/env bash
# What it costs to include each public header, as a Markdown table: preprocessed lines (without blank
# ones) and the user seconds of one g++, the least of three runs (of one where it takes longer than
# 5 s), beside Eigen/Dense alone. And what it costs to compile a file that localizes, header-only and
# with topobag::compiled: seconds likewise, and the compiler's memory.
#   bash tests/compile_cost.sh [HEADER...]      e.g. topobag/core.hpp; all of them by default
#   bash tests/compile_cost.sh localizing       the file that localizes, alone
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
flags=(-std=c++17 -O0 -Iinclude)
for package in eigen3 opencv4 libpq; do
  read -ra more < <(pkg-config --cflags "$package" 2>/dev/null || true) || true
  flags+=("${more[@]/#-I/-isystem}")
done
source=$(mktemp --suffix=.cpp)
cost=$(mktemp)
trap 'rm -f "$source" "$cost"' EXIT
TIMEFORMAT=%U

is_less() { awk -v a="$1" -v b="$2" 'BEGIN { exit !(a < b) }'; }

# measure HEADER: sets lines and seconds; false when it does not compile here.
measure() {
  echo "#include <$1>" >"$source"
  lines=$(g++ "${flags[@]}" -E -P "$source" 2>/dev/null | wc -l) || return 1
  seconds=
  for run in 1 2 3; do
    time=$({ time g++ "${flags[@]}" -fsyntax-only "$source" 2>/dev/null; } 2>&1) || return 1
    if [ -z "$seconds" ] || is_less "$time" "$seconds"; then seconds=$time; fi
    if is_less 5 "$seconds"; then break; fi
  done
}

# row HEADER: its line of the table.
row() {
  if measure "$1"; then
    awk -v header="$1" -v lines="$lines" -v seconds="$seconds" -v l="$base_lines" -v s="$base_seconds" \
      'BEGIN { printf "| %s | %d | %.2f | %.2f | %.2f |\n", header, lines, lines / l, seconds, seconds / s }'
  else
    echo "| $1 | – | – | – | – |"
  fi
}

# localizing_row NAME FLAG...: of the file that localizes, compiled with these flags.
localizing_row() {
  local name=$1 seconds= mb= run time kb
  shift
  for run in 1 2 3; do
    env time -f '%U %M' -o "$cost" g++ "${flags[@]}" "$@" -c "$source" -o /dev/null
    read -r time kb <"$cost"
    if [ -z "$seconds" ] || is_less "$time" "$seconds"; then seconds=$time mb=$((kb / 1024)); fi
    if is_less 5 "$seconds"; then break; fi
  done
  echo "| $name, ${*: -1} | $seconds | $mb |"
}

localizing() {
  type -P time >/dev/null || {
    echo "the compiler's memory takes GNU time (Debian: time)" >&2
    exit 1
  }
  cat >"$source" <<'END'
#include <topobag/recognition/relocalizer.hpp>
std::size_t matched(const topobag::Relocalizer<>& relocalizer, const topobag::TopologyGraph<>& query) {
  return relocalizer.localize(query).candidates.size();
}
END
  echo "| a file that localizes | seconds | MB |"
  echo "|---|---|---|"
  for level in -O0 -O2; do localizing_row header-only "$level"; done
  for level in -O0 -O2; do localizing_row "with \`topobag::compiled\`" -DTOPOBAG_COMPILED "$level"; done
}

headers=("$@")
if [ "${1:-}" = localizing ]; then
  localizing
  exit
fi
if [ $# -eq 0 ]; then
  mapfile -t headers < <(cd include && find topobag -name '*.hpp' -not -path '*/detail/*' | LC_ALL=C sort)
fi
measure Eigen/Dense
base_lines=$lines
base_seconds=$seconds
echo "| header | lines | × Eigen/Dense | seconds | × Eigen/Dense |"
echo "|---|---|---|---|---|"
printf "| Eigen/Dense | %d | 1.00 | %.2f | 1.00 |\n" "$base_lines" "$base_seconds"
for header in "${headers[@]}"; do row "$header"; done
if [ $# -eq 0 ]; then
  echo
  localizing
fi
