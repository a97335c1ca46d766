// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <istream>
#include <ostream>
#include <vector>

#include <topobag/error.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// Throws Error when the stream does not take them all.
inline void write_bytes(std::ostream& stream, const std::vector<std::uint8_t>& bytes) {
  stream.write(reinterpret_cast<const char*>(bytes.data()),
               static_cast<std::streamsize>(bytes.size()));
  if (!stream) throw Error("the bag could not be written");
}

/// The next `size` bytes, or fewer where the stream ends. Grows with what is really there: a false
/// size makes no room.
inline std::vector<std::uint8_t> read_at_most(std::istream& stream, std::uint64_t size) {
  constexpr std::uint64_t chunk = 65536;
  std::vector<std::uint8_t> bytes;
  while (bytes.size() < size) {
    const std::size_t old = bytes.size();
    const auto wanted = static_cast<std::size_t>(std::min(chunk, size - old));
    bytes.resize(old + wanted);
    stream.read(reinterpret_cast<char*>(bytes.data() + old), static_cast<std::streamsize>(wanted));
    const auto found = static_cast<std::size_t>(stream.gcount());
    if (found == wanted) continue;
    bytes.resize(old + found);
    break;
  }
  return bytes;
}

/// Throws FormatError when there are fewer than `size`.
inline void require_bytes(const std::vector<std::uint8_t>& bytes, std::uint64_t size) {
  if (bytes.size() < size) throw FormatError("it is cut off; take a complete copy");
}

/// The next `size` bytes. Throws FormatError when there are fewer.
inline std::vector<std::uint8_t> read_bytes(std::istream& stream, std::uint64_t size) {
  std::vector<std::uint8_t> bytes = read_at_most(stream, size);
  require_bytes(bytes, size);
  return bytes;
}

}  // namespace detail
}  // namespace v0
}  // namespace topobag
