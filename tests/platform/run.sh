#!/usr/bin/env bash
# The library's Windows branch, against the declarations that it uses of that system: what is called,
# and with what. It is not run, and no header of Windows is read.
#   bash tests/platform/run.sh [COMPILER]    clang++ by default
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
source .ci/packages.sh
need_packages pkg-config libeigen3-dev
read -ra eigen < <(pkg-config --cflags eigen3)
stubs=tests/platform/windows
strict=(-std=c++17 -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion -Werror)

# The core names the system in one place alone.
if grep -rnE '<(unistd|fcntl|io|windows|process|sys/[a-z]+)\.h>|__builtin_|\bssize_t\b' include/topobag \
  --include='*.hpp' | grep -vE '^include/topobag/(platform\.hpp|adaptors/)'; then
  echo "these name the system or the compiler: see platform.hpp"
  exit 1
fi

# Functions of POSIX are poisoned: what the Windows branch would call of them is an error.
printf '%s\n' '#include <fcntl.h>' '#include <sys/stat.h>' '#include <unistd.h>' '#include <Eigen/Dense>' \
  '#include <functional>' '#include <memory>' '#include <fstream>' '#include <iostream>' '#include <map>' \
  '#include <deque>' '#include <set>' '#include <random>' '#include <regex>' '#include <sstream>' \
  '#include <mutex>' '#include <thread>' '#include <condition_variable>' '#include <shared_mutex>' \
  '#pragma GCC poison getpid fsync flock fchmod realpath ssize_t' '#include <topobag/core.hpp>' |
  "${1:-clang++}" "${strict[@]}" -DTOPOBAG_WINDOWS -I"$stubs" -Iinclude "${eigen[@]/#-I/-isystem}" \
    -fsyntax-only -x c++ -
echo "the Windows branch compiles"
