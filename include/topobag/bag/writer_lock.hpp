// SPDX-License-Identifier: MIT
#pragma once

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <string>
#include <system_error>

#include <topobag/bag/atomic_file.hpp>
#include <topobag/error.hpp>

namespace topobag {
inline namespace v0 {

/// Holds off every other holder for the same file, in whatever process, until it goes: for who
/// loads a snapshot, adds to it and saves it again.
///
///     const WriterLock lock("room.bag");  // waits for its turn
///     auto bag = load<BagOfTopologyGraphs<>>("room.bag");
///     bag.add(id, graph);
///     save(bag, "room.bag");
///
/// It is the file's folder that is locked, since `save` replaces the file: nothing is left behind,
/// and files of one folder are written one after the other. (POSIX; a second lock in one thread
/// waits for ever.)
class WriterLock {
 public:
  /// Throws Error with the system's reason when the folder cannot be locked.
  explicit WriterLock(const std::string& path) {
    const std::string folder = detail::folder_of(detail::target_of(path));
    folder_ = ::open(folder.c_str(), O_RDONLY | O_CLOEXEC);
    int status = folder_ < 0 ? -1 : 0;
    while (folder_ >= 0 && (status = ::flock(folder_, LOCK_EX)) != 0 && errno == EINTR) continue;
    if (status == 0) return;
    const std::string reason = std::generic_category().message(errno);
    if (folder_ >= 0) ::close(folder_);
    throw Error(path + " cannot be written: its folder cannot be locked: " + reason);
  }

  WriterLock(const WriterLock&) = delete;
  WriterLock& operator=(const WriterLock&) = delete;
  ~WriterLock() { ::close(folder_); }

 private:
  int folder_ = -1;
};

}  // namespace v0
}  // namespace topobag
