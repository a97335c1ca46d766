#!/usr/bin/env bash
# Runs the benchmarks and writes their page: every table with the command that makes it, and how busy
# the machine was meanwhile.
#   bash benchmarks/page.sh [DATA]    DATA: folder of the sets that bench_places asks for; without it,
#                                     and without TOPOBAG_DATA, there is no table of recognition
# It builds into build/, as tests/run.sh does, and takes some minutes on two idle cores.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
data=${1:-${TOPOBAG_DATA:-}}
page=examples/docs/benchmarks.md
tables=$(mktemp)
trap 'rm -f "$tables"' EXIT

benches=(bench_delaunay bench_bag bench_matching bench_frontend bench_places)
cmake -S . -B build -DCMAKE_BUILD_TYPE=Release >/dev/null
cmake --build build --parallel "$(nproc)" --target "${benches[@]}" >/dev/null

load() { cut -d ' ' -f 1 /proc/loadavg; }

# section TITLE TEXT COMMAND...: a table, as the command prints it; DATA stands for the folder.
section() {
  local title=$1 text=$2 before output seconds
  shift 2
  before=$(load)
  echo "$title: $*" >&2
  SECONDS=0
  output=$("${@/#DATA/$data}")
  seconds=$SECONDS
  {
    printf '\n## %s\n\n%s\n\n    %s\n\n```text\n' "$title" "$text" "$*"
    grep -v '^{' <<<"$output" | sed "s#${data:-DATA}#DATA#g; s/[[:space:]]*$//"
    printf '```\n\n%d s; load %s before, %s after.\n' "$seconds" "$before" "$(load)"
  } >>"$tables"
}

if [ -n "$data" ]; then
  section "Recognition" \
    "Every tenth query of all shared sets, single frames and windows of 3 s, pooled: what one threshold for all finds and what it finds
falsely. The whole, of all queries, is in the [README](../../README.md#measured)." \
    build/benchmarks/bench_places --shared DATA --stride 10
fi
section "Matching" \
  "Two graphs of real key frames, the surest objects of each, every query of fr1_rpy with every key frame of fr1_xyz: the consistency search
with its pose, and the paper's padded cosine beside its plain formula." \
  build/benchmarks/bench_matching
section "A key frame in the front end" \
  "Lifting, fusing, looking up and adding, detector aside; and a lost tracker's queries." \
  build/benchmarks/bench_frontend
section "Retrieval and memory" \
  "The exact best ten, of a bag that grows; bytes are those of an encoded graph with its index. The answers are those of brute force, which
is checked." \
  build/benchmarks/bench_bag --graphs 1000,10000,100000 --queries 200
section "Delaunay edges" \
  "Beside CGAL itself, whose faster way counts; random layouts in an image of 640 × 480." \
  build/benchmarks/bench_delaunay
section "Compile cost" \
  "One include, beside Eigen alone; all headers: [compile cost](compile_cost.md)." \
  bash tests/compile_cost.sh topobag/core.hpp topobag/recognition/relocalizer.hpp \
  topobag/matching/match_graphs.hpp topobag/bag/indexed_bag.hpp topobag/edges/delaunay_edges2.hpp

{
  cat <<HEAD
# Benchmarks

Made by \`bash benchmarks/page.sh [DATA]\` on $(date -I), at commit $(git describe --always --dirty):
$(sed -n 's/^model name[^:]*: //p' /proc/cpuinfo | head -n 1), $(nproc) cores, $(c++ --version | head -n 1), release build. A load above 0 before a table means that
others worked on the machine meanwhile: times are then upper bounds, and ratios taken within one table say more than they do.
HEAD
  cat "$tables"
  cat <<'PEERS'

## Published figures of others

On their authors' machines and data, so no comparison but an order of magnitude.

| system | figure | source |
|---|---|---|
| DBoW2 | 3 ms to convert an image and 5 ms a query, at more than 19,000 images | its README |
| FILD++ (HNSW) | 22 ms an image, at 52,480 images | its paper |
| CLIPPER | 15 ms where the exact search takes 24 s, at 200 associations | its abstract |
| SG-Reg | 52 KB a query frame | its paper |
PEERS
} >"$page.new"
mv "$page.new" "$page"
