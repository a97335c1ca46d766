# Sourced by the scripts that build: installs Debian packages where that is possible.

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
