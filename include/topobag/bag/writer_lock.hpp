// SPDX-License-Identifier: MIT
#pragma once

#include <cerrno>
#include <string>
#include <system_error>

#include <topobag/bag/atomic_file.hpp>
#include <topobag/error.hpp>
#include <topobag/platform.hpp>

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
/// and files of one folder are written one after the other. (A second lock in one thread waits for
/// ever.)
class WriterLock {
 public:
  /// Throws Error with the system's reason when the folder cannot be locked.
  explicit WriterLock(const std::string& path)
      : folder_(detail::folder_of(detail::real_path(path))) {
    if (folder_.valid()) return;
    throw Error(path + " cannot be written: its folder cannot be locked: " +
                std::generic_category().message(errno));
  }

 private:
  detail::FolderLock folder_;
};

}  // namespace v0
}  // namespace topobag
