#!/usr/bin/env bash
# topobag as programs come by it: installed, as a sub-folder, fetched, by pkg-config, without CGAL.
#   bash tests/consumer/run.sh
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
source .ci/packages.sh
need_build_tools
need_packages pkg-config libeigen3-dev libcgal-dev libsqlite3-dev
here=tests/consumer
build=$PWD/build/consumer
rm -rf "$build"
version=$(sed -En 's/#define TOPOBAG_VERSION_(MAJOR|MINOR) ([0-9]+)/\2/p' include/topobag/version.hpp | paste -sd .)

# install PREFIX [OPTION...]: the library alone.
install() {
  local prefix=$1
  shift
  cmake -S . -B "$prefix-build" -DTOPOBAG_BUILD_TESTS=OFF -DTOPOBAG_BUILD_EXAMPLES=OFF \
    -DTOPOBAG_BUILD_BENCHMARKS=OFF "$@"
  cmake --build "$prefix-build" --parallel "$(nproc)"
  cmake --install "$prefix-build" --prefix "$prefix" >/dev/null
}

# consume PROJECT [OPTION...]: builds it without optimisation, and runs what it makes.
consume() {
  local project=$1 program
  shift
  echo "== $project $*"
  cmake -S "$here/$project" -B "$build/$project" --no-warn-unused-cli -D topobag_sources="$PWD" "$@"
  cmake --build "$build/$project" --parallel "$(nproc)"
  for program in core delaunay {slam,lidar,similarity}{,_compiled}; do
    if [ -e "$build/$project/$program" ]; then "$build/$project/$program"; fi
  done
}

# refuse PREFIX WANTED SENTENCE: CMake ends with that sentence.
refuse() {
  echo "== refused: $2"
  rm -rf "$build/refused"
  if cmake -S "$here/refused" -B "$build/refused" -D CMAKE_PREFIX_PATH="$1" -D wanted="$2" \
    >"$build/refused.txt" 2>&1; then
    echo "find_package(topobag $2) is not refused"
    return 1
  fi
  # CMake breaks lines where it likes.
  tr -s ' \n' ' ' <"$build/refused.txt" | grep -F "$3" || {
    cat "$build/refused.txt"
    echo "find_package(topobag $2) does not say: $3"
    return 1
  }
}

install "$build/whole" -D TOPOBAG_BUILD_COMPILED=ON
consume find_package -D CMAKE_PREFIX_PATH="$build/whole" -D wanted_version="$version"
consume add_subdirectory
consume fetch_content
consume programs

install "$build/without_cgal" -D CMAKE_DISABLE_FIND_PACKAGE_CGAL=ON
consume core_alone -D CMAKE_PREFIX_PATH="$build/without_cgal" -D wanted_version="$version" \
  -D CMAKE_DISABLE_FIND_PACKAGE_CGAL=ON
if find "$build/without_cgal/include" -name '*.hpp' -exec grep -l '<CGAL/' {} +; then
  echo "these need CGAL and were installed without it"
  exit 1
fi

# A later version, an earlier one whose interface may differ, and what is not there.
refuse "$build/whole" 99 "version: $(sed -En 's/.*PACKAGE_VERSION "(.*)".*/\1/p' \
  "$build"/whole/share/cmake/topobag/topobag-config-version.cmake | head -n 1)"
refuse "$build/whole" 0.0 'compatible with requested version "0.0"'
refuse "$build/whole" 'COMPONENTS;delaunay' "topobag has no component 'delaunay': there are"
refuse "$build/without_cgal" 'COMPONENTS;topobag' \
  'topobag was installed without CGAL: install it, then topobag again.'

# Without CMake. An install can be moved: the paths are relative.
mv "$build/whole" "$build/moved"
export PKG_CONFIG_PATH=$build/moved/share/pkgconfig
for package in topobag-core:core topobag:delaunay; do
  program=${package#*:}
  package=${package%:*}
  echo "== pkg-config $package"
  read -ra flags < <(pkg-config --cflags --libs "$package >= $version")
  c++ -std=c++17 "$here/$program.cpp" "${flags[@]}" -o "$build/$program"
  "$build/$program"
done
if pkg-config --exists 'topobag-core >= 99'; then
  echo "pkg-config takes $version for 99"
  exit 1
fi
