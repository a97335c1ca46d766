// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <istream>
#include <limits>
#include <ostream>
#include <string>
#include <vector>

#include <topobag/adaptors/orb_slam/saved_sightings.hpp>
#include <topobag/bag/atomic_file.hpp>
#include <topobag/bag/detail/storage/file_bytes.hpp>
#include <topobag/bag/snapshot_file.hpp>

namespace topobag {
inline namespace v0 {

/// The sightings into a file, beside the host's own map: complete under its name when this returns,
/// or, after an Error with the system's reason, as it was before.
inline void save_sightings(const std::vector<SavedSighting>& sightings, const std::string& path) {
  const std::vector<std::uint8_t> bytes = encode(sightings);
  AtomicFile file(path);
  std::ostream stream(file.buffer());
  stream.write(reinterpret_cast<const char*>(bytes.data()),
               static_cast<std::streamsize>(bytes.size()));
  if (!stream) file.fail();
  file.commit();
}

/// What `save_sightings` wrote. Throws Error when the file cannot be opened, and FormatError with
/// its name as `decode_sightings`.
inline std::vector<SavedSighting> load_sightings(const std::string& path) {
  return detail::read_file(path, [](std::istream& stream) {
    return decode_sightings(
        detail::read_at_most(stream, std::numeric_limits<std::uint64_t>::max()));
  });
}

}  // namespace v0
}  // namespace topobag
