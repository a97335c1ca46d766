#!/usr/bin/env bash
# Every CMake file asks for the one version that README.md names, that of Ubuntu 22.04, and uses nothing
# that came later: where a newer one is at hand, nothing else would tell.
#   bash tests/oldest_cmake.sh     says every violation and fails
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
oldest=3.22

# By CMake's release notes, what later versions have brought that a build like ours might use.
newer=(
  'FILE_SET' 'HEADER_SETS?(_TO_VERIFY)?' 'CXX_MODULES?' 'LINK_LIBRARIES_ONLY_TARGETS' # 3.23
  'FIND_PACKAGE_ARGS' 'OVERRIDE_FIND_PACKAGE' '<LINK_(LIBRARY|GROUP):' 'PATH_EQUAL' '<PATH:'
  'COMPILE_WARNING_AS_ERROR' 'CMAKE_COLOR_DIAGNOSTICS' 'DOWNLOAD_EXTRACT_TIMESTAMP' # 3.24
  '(end)?block ?\(' 'PROPAGATE' 'VALIDATOR' 'SYSTEM\)$' 'CMAKE_HOST_(LINUX|BSD)' '(LINUX|BSD)\)' # 3.25
  'COPY_FILE' 'COMPILE_ONLY' '<QUOTE>' 'DEPENDS_EXPLICIT_ONLY' '<LIST:' 'TEST_LAUNCHER' # 3.26 to 3.29
  'CMAKE_LINK_WARNING_AS_ERROR' 'cmake_pkg_config' 'CODEGEN' # 3.30, 3.31
)
mapfile -t files < <(find . \( -name build -o -name .git \) -prune -o \( -name CMakeLists.txt -o -name '*.cmake' \) -print)
# Not in comments.
if grep -nE "^[^#]*($(IFS='|' && echo "${newer[*]}"))" "${files[@]}"; then
  echo "that needs a CMake newer than $oldest"
  exit 1
fi
if grep -n 'cmake_minimum_required' "${files[@]}" | grep -v "(VERSION $oldest)"; then
  echo "that asks for another CMake than $oldest"
  exit 1
fi
grep -q "CMake $oldest or newer" README.md
echo "${#files[@]} CMake files use what $oldest has"
