// SPDX-License-Identifier: MIT
#pragma once

#include <cerrno>
#include <cstdint>
#include <fstream>
#include <istream>
#include <optional>
#include <ostream>
#include <string>
#include <system_error>
#include <utility>

#include <topobag/bag/atomic_file.hpp>
#include <topobag/bag/described_catalog.hpp>
#include <topobag/bag/snapshot.hpp>
#include <topobag/bag/snapshot_header.hpp>
#include <topobag/error.hpp>

namespace topobag {
inline namespace v0 {

namespace detail {

/// What `read(stream)` returns; its FormatErrors with the file's name before them.
template <typename Read>
auto read_file(const std::string& path, const Read& read) {
  std::ifstream stream(path, std::ios::binary);
  if (!stream) {
    throw Error(path + " cannot be opened: " + std::generic_category().message(errno));
  }
  try {
    return read(stream);
  } catch (const FormatError& error) {
    throw FormatError(path + ": " + error.what(), error.index());
  }
}

/// A file that is one bag.
template <typename Bag, typename Classes>
Bag load_file(const std::string& path, const Classes& classes, Bag empty) {
  return read_file(path, [&](std::istream& stream) {
    Bag bag = load<Bag>(stream, classes, std::move(empty));
    if (stream.peek() != std::istream::traits_type::eof()) {
      throw FormatError("it goes on after its last entry: it is damaged; take another copy");
    }
    return bag;
  });
}

}  // namespace detail

/// `save` into a file: complete and on the disk under its name when this returns (written beside
/// it, synced, renamed), or, after an Error that gives the system's reason, as it was before. A
/// process killed on the way leaves the old file and one beside it whose name has ".part-" in it.
/// Devices, pipes and folders are refused. Who loads, adds and saves holds a `WriterLock`
/// meanwhile.
template <typename Bag>
void save(const Bag& bag, const std::string& path, const SaveOptions& options = {}) {
  AtomicFile file(path);
  std::ostream stream(file.buffer());
  try {
    save(bag, stream, options);
  } catch (const Error&) {
    if (!stream) file.fail();
    throw;
  }
  file.commit();
}

/// `load` from a file, which holds one bag and nothing more.
///
///     bag = load<BagOfTopologyGraphs<>>("room.bag");  // or throws and leaves `bag` as it was
///
/// @param catalog_fingerprint  or all that is said of the classes, as a `DescribedCatalog`
/// Throws FormatError, or Error when the file cannot be opened; both begin with its name.
template <typename Bag = BagOfTopologyGraphs<>>
Bag load(const std::string& path, std::uint64_t catalog_fingerprint = 0, Bag empty = Bag{}) {
  return detail::load_file(path, catalog_fingerprint, std::move(empty));
}
/// The same.
template <typename Bag = BagOfTopologyGraphs<>>
Bag load(const std::string& path, const DescribedCatalog& classes, Bag empty = Bag{}) {
  return detail::load_file(path, classes, std::move(empty));
}

/// The classes that a saved bag keeps, if it does. Throws as `load`.
inline std::optional<DescribedCatalog> saved_catalog(const std::string& path) {
  return detail::read_file(path, [](std::istream& stream) { return saved_catalog(stream); });
}

/// The header of a saved bag.
inline SnapshotHeader inspect(const std::string& path) {
  return detail::read_file(path, [](std::istream& stream) { return inspect(stream); });
}

}  // namespace v0
}  // namespace topobag
