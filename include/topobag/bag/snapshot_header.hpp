// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <istream>
#include <string>
#include <vector>

#include <topobag/bag/detail/codec/bit_reader.hpp>
#include <topobag/bag/detail/codec/bit_writer.hpp>
#include <topobag/bag/detail/storage/crc32.hpp>
#include <topobag/bag/detail/storage/file_bytes.hpp>
#include <topobag/bag/graph_codec.hpp>
#include <topobag/error.hpp>
#include <topobag/types/ids.hpp>
#include <topobag/version.hpp>

namespace topobag {
inline namespace v0 {

/// What a saved bag says of itself before its entries.
struct SnapshotHeader {
  static constexpr std::uint32_t latest_version = 2;  ///< of the format that this library writes

  std::uint32_t format_version = 1;  ///< of the file: the least that holds its entries
  /// Of the topobag that wrote it: major · 65536 + minor · 256 + patch.
  std::uint32_t library_version =
      TOPOBAG_VERSION_MAJOR << 16 | TOPOBAG_VERSION_MINOR << 8 | TOPOBAG_VERSION_PATCH;
  std::uint32_t codec_version = 1;             ///< the latest one among its graphs
  std::uint8_t id_bytes = sizeof(KeyframeId);  ///< size of a key frame id
  std::uint8_t class_bytes = sizeof(ClassId);  ///< size of a class id
  std::uint8_t scalar_bytes = sizeof(double);  ///< of the graphs that were saved; any can be loaded
  std::uint64_t entries = 0;                   ///< how many follow
  std::uint64_t catalog_fingerprint = 0;       ///< see `fingerprint`; 0 = not stated
  bool catalog = false;                        ///< whether the catalog follows, in format 2
};

namespace detail {

/// As in PNG: a byte that is no text, our name, and line ends that a copy as text would change.
inline constexpr std::array<std::uint8_t, 8> snapshot_magic = {0x89, 'T',  'B',  'G',
                                                               '\r', '\n', 0x1A, '\n'};
inline constexpr std::size_t snapshot_header_bytes = 40;

}  // namespace detail

/// As it stands at the beginning of a saved bag.
inline std::vector<std::uint8_t> to_bytes(const SnapshotHeader& header) {
  detail::BitWriter writer;
  for (const std::uint8_t byte : detail::snapshot_magic) writer.put(byte, 8);
  writer.put(header.format_version, 32);
  writer.put(header.library_version, 32);
  writer.put(header.codec_version, 32);
  for (const std::uint8_t size : {header.id_bytes, header.class_bytes, header.scalar_bytes}) {
    writer.put(size, 8);
  }
  writer.put(header.catalog ? 1 : 0, 8);
  writer.put(header.entries, 64);
  writer.put(header.catalog_fingerprint, 64);
  std::vector<std::uint8_t> bytes = writer.take();
  detail::BitWriter checksum;
  checksum.put(detail::crc32(bytes.data(), bytes.size()), 32);
  for (const std::uint8_t byte : checksum.take()) bytes.push_back(byte);
  return bytes;
}

/// Reads the header of a saved bag and nothing more. Throws FormatError that says whether the file
/// is foreign, cut off, damaged, or of a later version.
inline SnapshotHeader inspect(std::istream& stream) {
  const auto& magic = detail::snapshot_magic;
  const std::vector<std::uint8_t> bytes =
      detail::read_at_most(stream, detail::snapshot_header_bytes + 4);
  const auto known = static_cast<std::ptrdiff_t>(std::min(bytes.size(), magic.size()));
  if (!std::equal(bytes.begin(), bytes.begin() + known, magic.begin())) {
    throw FormatError("it is not a bag saved by topobag, or a copy as text has damaged it");
  }
  detail::require_bytes(bytes, detail::snapshot_header_bytes + 4);
  detail::BitReader reader(bytes.data() + magic.size(), bytes.size() - magic.size());
  const auto number = [&](unsigned width) { return reader.get(width); };
  SnapshotHeader header;
  header.format_version = static_cast<std::uint32_t>(number(32));
  header.library_version = static_cast<std::uint32_t>(number(32));
  header.codec_version = static_cast<std::uint32_t>(number(32));
  header.id_bytes = static_cast<std::uint8_t>(number(8));
  header.class_bytes = static_cast<std::uint8_t>(number(8));
  header.scalar_bytes = static_cast<std::uint8_t>(number(8));
  const std::uint64_t parts = number(8);
  header.catalog = parts == 1;
  header.entries = number(64);
  header.catalog_fingerprint = number(64);
  if (number(32) != detail::crc32(bytes.data(), detail::snapshot_header_bytes)) {
    throw FormatError("its header is damaged; take another copy");
  }
  if (header.format_version > SnapshotHeader::latest_version ||
      header.codec_version > graph_codec_version || parts > 1 ||
      (header.catalog && header.format_version < 2)) {
    throw FormatError("it was saved by a later version of topobag (format " +
                      std::to_string(header.format_version) + "): update topobag");
  }
  if (header.format_version == 0 || header.id_bytes != sizeof(KeyframeId) ||
      header.class_bytes != sizeof(ClassId)) {
    throw FormatError("its ids or classes are of another size than topobag's");
  }
  return header;
}

}  // namespace v0
}  // namespace topobag
