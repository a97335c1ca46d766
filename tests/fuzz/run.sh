#!/usr/bin/env bash
# Fuzzes what reads foreign bytes, and the matcher, under AddressSanitizer and UBSan.
#   bash tests/fuzz/run.sh [SECONDS] [TARGET...]: so long each, one after the other; 60 s and all by default
# A finding is left in build/fuzz as crash-*: make a named test of it.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
source .ci/packages.sh
need_packages clang libclang-rt-dev libeigen3-dev libcgal-dev libcli11-dev libsqlite3-dev nlohmann-json3-dev \
  catch2

seconds=${1:-60}
shift || true
targets=("$@")
[ ${#targets[@]} -gt 0 ] || targets=(saved_bag graph_codec trajectory node_table box_file class_list sqlite_row delaunay match)
program=examples/topobag
declare -A sources=([node_table]="$program/node_table.cpp $program/csv_reader.cpp $program/appearance_columns.cpp
    $program/depth_column.cpp $program/label_column.cpp $program/path_kind.cpp"
  [box_file]="$program/box_files.cpp $program/box_reach.cpp $program/coco_file.cpp $program/image_names.cpp
    $program/json_output.cpp $program/csv_reader.cpp"
  [class_list]="$program/class_list.cpp $program/csv_reader.cpp" [sqlite_row]=-lsqlite3 [delaunay]="-lgmp -lmpfr")
out=build/fuzz
[ -d /dev/shm ] && export TMPDIR=/dev/shm # some write their input to files: in memory that takes no time
mkdir -p "$out"

# Seeds: what the project's own files hold.
for target in "${targets[@]}"; do mkdir -p "$out/$target"; done
seed() { if [ -d "$out/$1" ]; then cat "${@:3}" >"$out/$1/$2"; fi; }
seed saved_bag v1 tests/bag/frozen/v1.bag
seed graph_codec gravity <(printf '\x22\xf0\xff\xf3\xff\x63')
printf '1305031098.5 1 2 3 0 0 0 1\n1305031099.5 1 2 3 0.5 0.5 0.5 0.5\n' >"$out/tum"
printf '1 0 0 1 0 1 0 2 0 0 1 3\n' >"$out/kitti"
printf 'seq: 1\nscene: cafe\naligned: true\nfps: 10\n1 0 0 0 0 0 0 1\n' >"$out/openloris"
printf 'query,candidate,score\n7,3,0.5\n' >"$out/scores"
printf '\x93NUMPY\x01\x00\x46\x00%-69s\n\0\0\0\0\0\0\360?\0\0\0\0\0\0\0@' \
  "{'descr': '<f8', 'fortran_order': False, 'shape': (1, 2), }" >"$out/npy"
kind=0
for text in tum kitti openloris scores npy; do
  seed trajectory "$text" <(printf "\\x0$kind") "$out/$text"
  kind=$((kind + 1))
done
seed node_table sample <(head -n 20 examples/data/fr1_xyz.frames.csv) <(printf '\0') \
  <(head -n 60 examples/data/fr1_xyz.nodes.csv)
seed class_list coco <(printf 'tv\nlaptop\n\n')
seed sqlite_row row <(head -c 60 /dev/zero) <(printf '\x22\xf0\xff\xf3\xff\x63')
seed box_file yolo <(printf '\x01') <(printf '0 0.5 0.5 0.1 0.2 0.9\n1 0.1 0.1 0.1 0.1\n')
seed box_file coco <(printf '\x00') \
  <(printf '[{"image_id": 1, "category_id": 1, "bbox": [1, 2, 3, 4], "score": 0.5}]')

build() {
  # shellcheck disable=SC2086 # several words
  clang++ -std=c++17 -O1 -g -fsanitize=fuzzer,address,undefined -fno-sanitize-recover=undefined \
    -frounding-math -Iinclude -Itests -I$program -isystem /usr/include/eigen3 \
    "tests/fuzz/$1.cpp" ${sources[$1]:-} -o "$out/fuzz_$1"
}
running=0
for target in "${targets[@]}"; do
  build "$target" &
  running=$((running + 1))
  if [ $running -ge "$(nproc)" ]; then
    wait -n
    running=$((running - 1))
  fi
done
for ((; running > 0; running--)); do wait -n; done

for target in "${targets[@]}"; do
  "$out/fuzz_$target" -max_total_time="$seconds" -artifact_prefix="$out/crash-$target-" \
    "$out/$target" 2>"$out/log.txt" || { tail -n 40 "$out/log.txt" && exit 1; }
  echo "$target: $(grep '^Done' "$out/log.txt")"
done
