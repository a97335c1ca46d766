#!/usr/bin/env bash
# Mutation check: plants the small faults of faults.txt in a copy of include/ and tells which of them no
# test notices; fails when fewer than 95 % are noticed.
#   bash tests/mutation/run.sh [PATTERN]: the faults in headers that match the regular expression; all by default
# A folder's faults are compiled into its tests at once, BEFORE becoming (planted(N) ? (AFTER) : (BEFORE)).
# Then the tests run once for each fault: those of its header first, the whole folder's when these pass.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
source .ci/packages.sh
need_build_tools
need_packages libeigen3-dev libcgal-dev catch2 nlohmann-json3-dev libsqlite3-dev

pattern=${1:-}
limit=300 # s; a fault may never end
out=build/mutation
flags=(-std=c++17 -O1 -w -frounding-math -I. -I"$out/include" -Itests -isystem /usr/include/eigen3
  -DTOPOBAG_SOURCES="\"$PWD\"" -DTOPOBAG_HAS_SQLITE -include "$out/common.hpp")
mkdir -p "$out"
rm -rf "$out/include"
cp -r include "$out"

# plant HEADER BEFORE AFTER NUMBER: in the copy.
plant() {
  local file=$out/include/topobag/$1 text
  text=$(<"$file")
  if [ "$(grep -oF -- "$2" "$file" | wc -l)" -ne 1 ]; then
    echo "$1 holds this not once: $2"
    exit 1
  fi
  echo "${text/"$2"/"(planted($4) ? ($3) : ($2))"}" >"$file"
}

# The list: "== HEADER", and for each fault "- BEFORE" and "+ AFTER"; "? WHY" before a fault that no test
# can notice.
headers=() texts=() reasons=()
why=
while read -r mark text; do
  case $mark in
    ==) header=$text ;;
    \?) why=$text ;;
    -) before=$text ;;
    +)
      if [[ $header =~ $pattern ]]; then
        plant "$header" "$before" "$text" ${#headers[@]}
        headers+=("$header") texts+=("$before  ->  $text") reasons+=("$why")
      fi
      why=
      ;;
  esac
done <tests/mutation/faults.txt

# folder_of HEADER: where its tests are; details are tested by what uses them.
folder_of() {
  local folder=${1%/*}
  echo "${folder%/detail}"
}

# build FOLDER: its tests as one unit. One file calls its own layouts as others do; OpenCV need not be here.
build() {
  local file name=${1//\//_}
  for file in tests/"$1"/{,detail/}test_*.cpp; do
    case $file in
      *\** | *test_delaunay_edges3.cpp | *test_opencv.cpp) ;;
      *) echo "#include \"$file\"" ;;
    esac
  done >"$out/$name.cpp"
  c++ "${flags[@]}" "$out/$name.cpp" "$out/main.o" -pthread -lsqlite3 -lgmp -lmpfr -o "$out/$name"
  "$out/$name" '~[long]' >"$out/$name.txt" || { # no fault is planted yet
    cat "$out/$name.txt"
    exit 1
  }
}

# notices NUMBER FILTER: whether a test of the fault's folder fails, ends the program or does not end.
notices() {
  local name
  name=$(folder_of "${headers[$1]}")
  ! TOPOBAG_FAULT=$1 timeout "$limit" "$out/${name//\//_}" -a '-#' "$2" &>/dev/null
}

# try NUMBER: says what becomes of the fault.
try() {
  local own=${headers[$1]##*/} result=survived
  own=test_${own%.hpp}
  if notices "$1" "[#$own]~[long]" || notices "$1" '~[long]'; then result=noticed; fi
  if [ $result = survived ] && [ -n "${reasons[$1]}" ]; then result=explained; fi
  echo "$result: ${headers[$1]}: ${texts[$1]}${reasons[$1]:+ (${reasons[$1]})}"
}

# at_once COMMAND ITEM...: the command for each item, as many at a time as there are processors.
at_once() {
  local command=$1 item
  shift
  for item in "$@"; do
    while [ "$(jobs -rp | wc -l)" -ge "$(nproc)" ]; do wait -n || return 1; done
    "$command" "$item" &
  done
  while [ -n "$(jobs -rp)" ]; do wait -n || return 1; done
}

cat >"$out/common.hpp" <<'EOF'
#pragma once
#include <cstdlib>
#include <Eigen/Dense>
#include "catch.hpp"
inline const char* const fault = std::getenv("TOPOBAG_FAULT");
inline const int fault_number = fault == nullptr ? -1 : std::atoi(fault);
inline bool planted(int number) { return number == fault_number; }
EOF
c++ "${flags[@]:0:${#flags[@]}-2}" -x c++-header "$out/common.hpp" -o "$out/common.hpp.gch"
[ "$out/main.o" -nt tests/main.cpp ] || c++ -std=c++17 -O1 -c tests/main.cpp -Itests -o "$out/main.o"

mapfile -t folders < <(for header in "${headers[@]}"; do folder_of "$header"; done | sort -u)
at_once build "${folders[@]}"
at_once try "${!headers[@]}" | tee "$out/results.txt"

noticed=$(grep -c ^noticed "$out/results.txt" || true)
explained=$(grep -c ^explained "$out/results.txt" || true)
echo "$noticed of ${#headers[@]} faults are noticed; $explained of the others are explained"
[ $((100 * noticed)) -ge $((95 * ${#headers[@]})) ]
