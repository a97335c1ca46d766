// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include <topobag/bag/detail/codec/bit_reader.hpp>
#include <topobag/bag/detail/codec/bit_writer.hpp>
#include <topobag/bag/entry_info.hpp>
#include <topobag/bag/graph_codec.hpp>
#include <topobag/error.hpp>
#include <topobag/types/ids.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// One entry of a bag with its graph still encoded.
struct EntryRecord {
  KeyframeId id{};
  EntryInfo info;
  std::vector<std::uint8_t> graph;
};

inline constexpr unsigned has_stamp = 1, has_pose = 2, has_label = 4, has_image = 8;

inline void put_double(BitWriter& writer, double x) {
  std::uint64_t bits = 0;
  std::memcpy(&bits, &x, sizeof bits);
  writer.put(bits, 64);
}

inline double get_double(BitReader& reader) {
  const std::uint64_t bits = reader.get(64);
  double x = 0.0;
  std::memcpy(&x, &bits, sizeof x);
  return x;
}

/// Throws FormatError.
inline ImageDescriptor get_image(BitReader& reader) {
  const auto number = static_cast<std::uint32_t>(reader.get(32));
  ImageDescriptor::Bytes bytes(static_cast<std::size_t>(reader.get(16)));
  for (std::int8_t& x : bytes) {
    x = static_cast<std::int8_t>(static_cast<std::uint8_t>(reader.get(8)));
  }
  try {
    const ImageKind kind(number, bytes.size());
    return ImageDescriptor(kind, std::move(bytes));
  } catch (const InvalidValue& error) {
    throw FormatError(std::string(error.what()) + ": it is damaged");
  }
}

/// The entry as bytes: id, session, which of stamp, pose, label and image follow, these to the last
/// bit, graph.
inline std::vector<std::uint8_t> to_bytes(const EntryRecord& entry) {
  BitWriter writer;
  writer.put(value(entry.id), 64);
  writer.put(entry.info.session, 32);
  writer.put((entry.info.stamp ? has_stamp : 0) | (entry.info.T_world_camera ? has_pose : 0) |
                 (entry.info.label.empty() ? 0 : has_label) |
                 (entry.info.image.known() ? has_image : 0),
             8);
  if (entry.info.stamp) put_double(writer, *entry.info.stamp);
  if (entry.info.T_world_camera) {
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 4; ++column) {
        put_double(writer, entry.info.T_world_camera->matrix()(row, column));
      }
    }
  }
  if (!entry.info.label.empty()) {
    writer.put(entry.info.label.size(), 32);
    for (const char letter : entry.info.label) writer.put(static_cast<std::uint8_t>(letter), 8);
  }
  if (entry.info.image.known()) {
    writer.put(entry.info.image.kind().number(), 32);
    writer.put(entry.info.image.kind().length(), 16);
    for (const std::int8_t x : entry.info.image.bytes())
      writer.put(static_cast<std::uint8_t>(x), 8);
  }
  std::vector<std::uint8_t> bytes = writer.take();
  bytes.insert(bytes.end(), entry.graph.begin(), entry.graph.end());
  return bytes;
}

/// Throws FormatError.
inline EntryRecord entry_of(const std::vector<std::uint8_t>& bytes) {
  BitReader reader(bytes.data(), bytes.size());
  EntryRecord entry;
  entry.id = KeyframeId{reader.get(64)};
  entry.info.session = static_cast<std::uint32_t>(reader.get(32));
  const std::uint64_t parts = reader.get(8);
  if (parts > (has_stamp | has_pose | has_label | has_image)) {
    throw FormatError("it holds what this version of topobag does not know: it is damaged");
  }
  if ((parts & has_stamp) != 0) entry.info.stamp = get_double(reader);
  if ((parts & has_pose) != 0) {
    Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 4; ++column) T.matrix()(row, column) = get_double(reader);
    }
    entry.info.T_world_camera = T;
  }
  if ((parts & has_label) != 0) {
    const std::uint64_t length = reader.get(32);
    if (length > reader.bits_left() / 8) throw FormatError("its label is cut off: it is damaged");
    for (std::uint64_t i = 0; i < length; ++i) {
      entry.info.label += static_cast<char>(reader.get(8));
    }
  }
  if ((parts & has_image) != 0) entry.info.image = get_image(reader);
  const auto rest = static_cast<std::ptrdiff_t>(reader.bits_left() / 8);
  entry.graph.assign(bytes.end() - rest, bytes.end());
  return entry;
}

}  // namespace detail
}  // namespace v0
}  // namespace topobag
