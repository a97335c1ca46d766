#!/usr/bin/env bash
# Builds the topobag program and re-localizes one sequence of the sample data in a map of another.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source .ci/packages.sh

build_program

drawing=$PWD/build/examples/fr1_rpy_in_fr1_xyz.svg
report=$PWD/build/examples/fr1_rpy_in_fr1_xyz.html
build/examples/topobag localize --map examples/data/fr1_xyz --query examples/data/fr1_rpy \
  --camera 517.3,516.5,318.6,255.3 --keyframe-interval 0 --svg "$drawing" --report "$report"
echo "Drawing: $drawing"
echo "Report: $report (open it in a browser)"
