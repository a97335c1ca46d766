# Sourced by the scripts that build: installs Debian packages where that is possible, and builds.

# need_packages PACKAGE...: installs those that are missing, or ends with their names.
need_packages() {
  local package missing=() as_root=()
  for package in "$@"; do
    dpkg-query -W -f '${Status}' "$package" 2>/dev/null | grep -q 'ok installed' || missing+=("$package")
  done
  if [ ${#missing[@]} -eq 0 ]; then return; fi
  if [ "$(id -u)" -ne 0 ]; then as_root=(sudo -n); fi
  if ! command -v apt-get >/dev/null || ! "${as_root[@]}" true 2>/dev/null; then
    echo "These Debian packages (or what they hold) are missing; install them first: ${missing[*]}" >&2
    exit 1
  fi
  echo "Installing ${missing[*]}"
  "${as_root[@]}" apt-get update -qq
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
    apt-get install -y -qq --no-install-recommends "${missing[@]}" >/dev/null
}

# need_build_tools: a C++ compiler, CMake and make, wherever they come from.
need_build_tools() {
  local packages=()
  command -v c++ >/dev/null || packages+=(g++)
  command -v cmake >/dev/null || packages+=(cmake)
  command -v make >/dev/null || command -v ninja >/dev/null || packages+=(make)
  need_packages "${packages[@]}"
}

# build_program: build/examples/topobag, from the project's folder; says something only when it fails.
build_program() {
  local log=build/examples/build.log
  need_build_tools
  need_packages libeigen3-dev libcgal-dev libcli11-dev nlohmann-json3-dev
  mkdir -p build/examples
  [ -e build/examples/topobag ] || echo "Building the topobag program, some minutes; what the compiler says: $log"
  if ! { cmake -S . -B build && cmake --build build --parallel "$(nproc)" --target topobag_cli; } >"$log" 2>&1; then
    cat "$log" >&2
    exit 1
  fi
}
