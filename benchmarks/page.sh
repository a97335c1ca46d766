#!/usr/bin/env bash
# Runs the benchmarks and writes their page: every table with the command that makes it, and how busy
# the machine was meanwhile.
#   bash benchmarks/page.sh [DATA]    DATA: folder of the sets that bench_places asks for; without it,
#                                     and without TOPOBAG_DATA, there is no table of recognition
# It builds into build/, as tests/run.sh does, and takes some minutes on two idle cores. Where CMake
# finds hnswlib and faiss (Debian: libhnswlib-dev, libfaiss-dev), retrieval stands beside them.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
data=${1:-${TOPOBAG_DATA:-}}
page=examples/docs/benchmarks.md
tables=$(mktemp)
trap 'rm -f "$tables"' EXIT

benches=(bench_delaunay bench_bag bench_consensus bench_mask bench_matching bench_moving_map bench_frontend
  bench_nees bench_places)
cmake -S . -B build -DCMAKE_BUILD_TYPE=Release >/dev/null
cmake --build build --parallel "$(nproc)" --target "${benches[@]}" >/dev/null

load() { cut -d ' ' -f 1 /proc/loadavg; }

# section TITLE TEXT COMMAND...: a table, as the command prints it but for the lines that are hidden; DATA
# stands for the folder.
hidden='^\{'
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
    grep -vE "$hidden" <<<"$output" | sed "s#${data:-DATA}#DATA#g; s/[[:space:]]*$//"
    printf '```\n\n%d s; load %s before, %s after.\n' "$seconds" "$before" "$(load)"
  } >>"$tables"
}

if [ -n "$data" ]; then
  hidden='^\{| other +[0-9]+ '
  section "Recognition" \
    "Every tenth query of all shared sets, single frames and windows of 3 s, pooled: what one threshold for all finds and what it finds
falsely. Pairs of different places stand in the pool alone. The whole, of all queries, is in the [README](../../README.md#measured)." \
    build/benchmarks/bench_places --shared DATA --stride 10
  hidden='^\{'
fi
section "Consensus" \
  "Which pairs of objects are one: the library beside a spectral relaxation as in CLIPPER and a largest clique as in TEASER++, both
this project's own and plain, with one tolerance for all pairs. Every query of fr1_rpy meets every key frame of fr1_xyz, and the best by the
method's own measure is its answer, right or wrong: no decision is made. Silent: no three pairs agree; the rest are imprecise." \
  build/benchmarks/bench_consensus
if [ -n "$data" ]; then
  section "Consensus, with a triangulated depth" \
    "The same of fr3_walking_xyz in fr3_sitting_xyz." \
    build/benchmarks/bench_consensus DATA/nodes/fr3_sitting_xyz.yolov8nseg_tri \
    DATA/nodes/fr3_walking_xyz.yolov8nseg_tri 535.4,539.2,320.1,247.6
fi
section "Matching" \
  "Two graphs of real key frames, the surest objects of each, every query of fr1_rpy with every key frame of fr1_xyz: the consistency search
with its pose, with what objects look like and without, and the paper's padded cosine beside its plain formula. Looks should cost 1.2 times at most." \
  build/benchmarks/bench_matching
if [ -n "$data" ]; then
  section "What poses know of their doubt" \
    "The normalised estimation error squared (NEES) of true matches, by how many objects were matched and by how far the pose turns the view of
them: of poses whose covariances are honest the mean is 6 and the median 5.35; less says that they know more than they claim. Some true poses
match other objects of a class than the right ones, which no noise of positions covers: the second mean leaves them out." \
    build/benchmarks/bench_nees DATA
fi
section "A key frame in the front end" \
  "Lifting, fusing, looking up and adding, detector aside; and a lost tracker's queries. Then what an object's colours cost: boxes of 100 × 100 px
of an image of 640 × 480, whose mean colour comes once; a box should take 20 µs at most." \
  build/benchmarks/bench_frontend
if [ -n "$data" ]; then
  section "Features on people" \
    "The camera's motion of fr3_walking_xyz, estimated of all features and of those that the mask leaves, by the share of the image that people
cover. True are the camera's poses and the boxes of people; simulated is all else: 1,000 features, evenly spread, 1 px and the depth noise of
\`NodeNoise\` off; people fill the ellipse within their boxes, 1 to 2.5 m away, walk level at up to 1.2 m/s, and each point of them moves by
0.2 m/s (σ an axis) besides; the background is 1.5 to 4.5 m away. Nobody is where the detector tells of nobody; no match is wrong. The
estimate is \`refined_motion\`, robust by its kernel. Errors: median and 95 %." \
    build/benchmarks/bench_mask DATA
fi
section "Retrieval and memory" \
  "The exact best ten, of a bag that grows; bytes are those of an encoded graph with its index. The answers are those of brute force, which
is checked. Where they are there, hnswlib and faiss (HNSW, M = 16, ef 200, one thread) are asked for the same graphs as vectors of 256 numbers." \
  build/benchmarks/bench_bag --graphs 1000,10000,100000 --queries 200 --neighbor-graphs 10000
section "When a loop was closed" \
  "All poses of a map set anew, the least of three, beside an \`update\` of each key frame and, on disk, beside a transaction in which SQLite itself
gives as many rows of a plain table seven numbers; maps in a folder in memory. Below, a register of key frames beside an ORB-SLAM that grows,
each key frame with its window as it is fused, beside a std::map of numbers that grows as much: what a key frame costs, and how many times what
it costs in the first row, which would be 100 in the last if each looked at all before it. 500 poses should take 50 ms at most." \
  build/benchmarks/bench_moving_map /dev/shm
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
$(sed -n 's/^model name[^:]*: //p' /proc/cpuinfo | head -n 1), $(nproc) cores, shared with others' work, $(c++ --version | head -n 1), release build. A load above 0 before a table means that
others worked on the machine meanwhile: times are then upper bounds, and ratios taken within one table say more than they do.
HEAD
  cat "$tables"
  cat <<'PEERS'

## Measured by hand beside the project

On 2026-11-22, on two shared cores of an AMD EPYC, one thread; these systems are not built here, and this script has not made the figures.

| system | figure | conditions |
|---|---|---|
| DBoW2 as ORB-SLAM2 asks it | a query 0.59, 10.9 and 55 ms at 1,000, 10,000 and 50,000 key frames | vocabulary of 10^6 words, 861 descriptors a frame, which take 2.0 ms to transform; 38 KB a key frame |
| hnswlib, exact; faiss, flat | 0.52 and 1.87 ms at 10^5; 8.8 and 19.9 ms at 10^6 | random vectors of 64 numbers, best ten |
| hnswlib, HNSW, ef 200 | 0.17 ms with .83 of the best ten at 10^5; 0.32 ms with .53 at 10^6 | the same |
| hnswlib, HNSW, ef 1000 | 0.80 ms with .98 at 10^5; 1.6 ms with .81 at 10^6 | the same |

## Published figures of others

As they are published, not run here: on their authors' machines and data, so no comparison but an order of magnitude.

| system | figure | source |
|---|---|---|
| DBoW2 | 3 ms to convert an image and 5 ms a query, at more than 19,000 images | its README |
| FILD++ (HNSW) | 22 ms an image, at 52,480 images | its paper |
| CLIPPER | 15 ms where the exact search takes 24 s, at 200 associations | its abstract |
| SG-Reg | 52 KB a query frame | its paper |
PEERS
} >"$page.new"
mv "$page.new" "$page"
