#!/usr/bin/env bash
# Builds the topobag program and prints the README's comparison in Markdown: every similarity and the
# paper's whole pipeline beside the default, on node tables at full rate.
#   bash examples/compare_all.sh FOLDER
set -euo pipefail
nodes=$(realpath "${1:?give the folder of the node tables}")
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source .ci/packages.sh

build_program

# compare TITLE OPTION...: from single frames, and from windows.
compare() {
  for window in 0 3; do
    echo "**$1, $([ "$window" = 0 ] && echo "single frames" || echo "windows of $window s")**"
    echo
    build/examples/topobag compare "${@:2}" --window "$window" --markdown
    echo
  done
}
fr1=(--camera 517.3,516.5,318.6,255.3)
fr3=(--camera 535.4,539.2,320.1,247.6)
compare "fr1_rpy in fr1_xyz, PicoDet-S" "${fr1[@]}" --min-confidence 0.35 \
  --map "$nodes/tum_fr1_xyz.picodet_s_416" --query "$nodes/tum_fr1_rpy.picodet_s_416"
compare "fr1_rpy in fr1_xyz, YOLOX-Nano" "${fr1[@]}" \
  --map "$nodes/tum_fr1_xyz.yolox_nano_416" --query "$nodes/tum_fr1_rpy.yolox_nano_416"
compare "fr3_walking_xyz in fr3_sitting_xyz, YOLOv8n-seg" "${fr3[@]}" \
  --map "$nodes/fr3_sitting_xyz.yolov8nseg_tri" --query "$nodes/fr3_walking_xyz.yolov8nseg_tri"
compare "fr3_long_office, places seen more than 20 s before, YOLO" "${fr3[@]}" \
  --nodes "$nodes/fr3_long_office.eao_yolo_tri"
