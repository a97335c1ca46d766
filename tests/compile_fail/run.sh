#!/usr/bin/env bash
# What must not compile, and what is said of it. In each file here MISFIT numbers the ways in which a
# user's type may fail to fit: the first error has to hold the sentence beside the number. Without
# MISFIT the file compiles, and no warning is given.
#   bash tests/compile_fail/run.sh [COMPILER [STANDARD]]    g++ 17 by default
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
source .ci/packages.sh
need_packages g++ pkg-config libeigen3-dev libcgal-dev libsqlite3-dev
export LC_ALL=C
compiler=${1:-g++}
standard=${2:-17}
build=build/compile_fail/$(basename "$compiler")-$standard
mkdir -p "$build"
read -ra eigen < <(pkg-config --cflags eigen3)
flags=(-std=c++"$standard" -Iinclude "${eigen[@]/#-I/-isystem}"
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion -Wno-unused -Werror)
failed=0

# fail WHAT: the compiler did not say what it should have.
fail() {
  echo "FAILED: $1" >&2
  head -n 20 "$build/log.txt" >&2
  failed=$((failed + 1))
}

compile() { "$compiler" "${flags[@]}" -fsyntax-only "$@" 2>"$build/log.txt"; }

# Eigen, compiled once: most of the time goes into what all files include.
precompiled=$build/eigen.hpp
echo '#include <Eigen/Dense>' >"$precompiled"
"$compiler" "${flags[@]}" -x c++-header "$precompiled" -o "$precompiled.gch"

for file in tests/compile_fail/*.cpp; do
  compile -include "$precompiled" "$file" || fail "$file does not compile without a misfit"
  while IFS=' ' read -r number sentence; do
    if compile -include "$precompiled" -w -Wfatal-errors -DMISFIT="$number" "$file"; then
      fail "$file compiles with misfit $number"
    elif ! grep -m 1 'error:' "$build/log.txt" | grep -qF "$sentence"; then
      fail "$file, misfit $number: the first error is not '$sentence'"
    fi
  done < <(sed -En 's#^// MISFIT ([0-9]+): #\1 #p' "$file")
done

# -ffast-math is warned about, on request it is not; a header of the system is no excuse.
flags=(-std=c++"$standard" -isystem include "${eigen[@]/#-I/-isystem}" -ffast-math)
file=tests/compile_fail/fast_math.cpp
compile "$file"
grep -q 'warning: .*topobag: -ffast-math removes the checks for NaN' "$build/log.txt" ||
  fail "-ffast-math is not warned about"
for silence in -DTOPOBAG_ALLOW_FAST_MATH -fno-finite-math-only; do
  compile -Werror "$silence" "$file" || fail "$silence does not silence the warning of -ffast-math"
done

# Under an earlier standard one sentence is said, not hundreds.
for header in adaptors/orb_slam adaptors/topology_thread core; do
  if "$compiler" -std=c++14 -Iinclude "${eigen[@]}" -fsyntax-only -x c++ - 2>"$build/log.txt" \
    <<<"#include <topobag/$header.hpp>"; then
    fail "$header.hpp compiles in C++14"
  elif ! grep -m 1 'error:' "$build/log.txt" | grep -qF 'topobag needs C++17: compile with -std=c++17'; then
    fail "$header.hpp in C++14: the first error is not that topobag needs C++17"
  elif [ "$(grep -c 'error:' "$build/log.txt")" -gt 2 ]; then
    fail "$header.hpp in C++14: more is said than that topobag needs C++17"
  fi
done

[ "$failed" -eq 0 ]
