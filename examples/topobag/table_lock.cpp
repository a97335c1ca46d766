// SPDX-License-Identifier: MIT
#include "table_lock.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "input_error.hpp"
#include "node_table.hpp"

namespace program {
namespace {

/// Whether an open file still has its name: who held it before took it away at the end.
bool has_name(int file, const std::string& path) {
  struct ::stat opened {
  }, named{};
  return ::fstat(file, &opened) == 0 && ::stat(path.c_str(), &named) == 0 &&
         opened.st_dev == named.st_dev && opened.st_ino == named.st_ino;
}

}  // namespace

TableLock::TableLock(const std::string& set) : path_(set_name(set) + ".partial.lock") {
  while (file_ < 0 || !has_name(file_, path_)) {
    if (file_ >= 0) ::close(file_);
    file_ = ::open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (file_ < 0) {
      throw InputError(path_, "it cannot be written: " + std::generic_category().message(errno));
    }
    if (::flock(file_, LOCK_EX | LOCK_NB) == 0) continue;
    const int reason = errno;
    ::close(file_);
    if (reason != EWOULDBLOCK) {
      throw InputError(path_, "it cannot be locked: " + std::generic_category().message(reason));
    }
    throw InputError("--out " + set,
                     "another run is making this table; wait until it is done, or give another "
                     "name");
  }
}

TableLock::~TableLock() {
  ::unlink(path_.c_str());
  ::close(file_);
}

}  // namespace program
