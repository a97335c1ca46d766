#!/usr/bin/env bash
# Which lines of include/ the tests reach, without the [long] ones and those of the program: by folder, the
# headers below the limit, and in all; fails below it. Templates that no test instantiates have no lines.
#   bash tests/coverage.sh [LIMIT]: in per cent, 95 by default
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source .ci/packages.sh
need_build_tools
need_packages libeigen3-dev libcgal-dev catch2 nlohmann-json3-dev libsqlite3-dev gcovr

build=build/coverage
# A build type of its own: nothing is optimised, so every line is there. Threads count as well, hence atomic.
cmake -S . -B "$build" -DCMAKE_BUILD_TYPE=Coverage -DCMAKE_CXX_FLAGS="--coverage -fprofile-update=atomic" \
  -DTOPOBAG_BUILD_EXAMPLES=OFF -DTOPOBAG_BUILD_BENCHMARKS=OFF
cmake --build "$build" --parallel "$(nproc)" --target topobag_tests
find "$build" -name '*.gcda' -delete # of an earlier run
"$build"/tests/topobag_tests '~[long]'

gcovr --root . --filter include/ --csv --output "$build/lines.csv" "$build"
tail -n +2 "$build/lines.csv" | sort | awk -F, -v limit="${1:-95}" '
  {
    split($1, part, "/")
    folder = part[4] == "" ? "." : part[3]
    lines[folder] += $2; reached[folder] += $3
    all += $2; all_reached += $3
    if (100 * $3 < limit * $2) low[++lows] = sprintf("%5.1f %%  %s, %d of %d lines", 100 * $3 / $2, $1, $3, $2)
  }
  END {
    for (i = 1; i <= lows; ++i) print low[i]
    for (folder in lines) printf "%5.1f %%  %s\n", 100 * reached[folder] / lines[folder], folder | "sort -k3"
    close("sort -k3")
    printf "%5.1f %%  of %d lines of include/\n", 100 * all_reached / all, all
    exit 100 * all_reached < limit * all
  }'
