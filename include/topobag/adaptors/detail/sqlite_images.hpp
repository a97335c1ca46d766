// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <topobag/adaptors/detail/sqlite_connection.hpp>
#include <topobag/adaptors/detail/sqlite_row.hpp>
#include <topobag/adaptors/detail/sqlite_schema.hpp>
#include <topobag/adaptors/detail/sqlite_statement.hpp>
#include <topobag/error.hpp>
#include <topobag/types/ids.hpp>
#include <topobag/types/image_descriptor.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// The table of whole images' descriptors, which a map has from its first one on; who knows nothing
/// of it goes on with the map as before. What replaces or erases a key frame takes its image along.
inline constexpr const char* sqlite_image_table = R"sql(
CREATE TABLE IF NOT EXISTS image(
  keyframe INTEGER PRIMARY KEY,
  kind INTEGER NOT NULL,
  descriptor BLOB NOT NULL,
  checksum INTEGER NOT NULL);
CREATE TRIGGER IF NOT EXISTS image_erase AFTER DELETE ON keyframe BEGIN
  DELETE FROM image WHERE keyframe = old.id; END;
CREATE TRIGGER IF NOT EXISTS image_replace AFTER UPDATE OF graph ON keyframe BEGIN
  DELETE FROM image WHERE keyframe = old.id; END;
)sql";

/// Writes the image of a key frame whose row has just been written, if it is known.
inline void write_image(const SqliteConnection& connection, KeyframeId id,
                        const ImageDescriptor& image) {
  if (!image.known()) return;
  connection.run(sqlite_image_table);
  const std::vector<std::uint8_t> bytes(image.bytes().begin(), image.bytes().end());
  SqliteStatement(connection,
                  "INSERT OR REPLACE INTO image(keyframe, kind, descriptor, checksum)"
                  " VALUES(?, ?, ?, ?)")
      .bind(sqlite_id(id), std::int64_t{image.kind().number()}, bytes, checksum_of(bytes))
      .step();
}

/// Reads the images of key frames, one by one.
class SqliteImages {
 public:
  explicit SqliteImages(const SqliteConnection& connection)
      : connection_(connection),
        any_(sqlite_number(connection,
                           "SELECT count(*) FROM sqlite_master WHERE type = 'table' AND"
                           " name = 'image'") > 0) {}

  /// Unknown where there is none. Throws FormatError when it is damaged.
  ImageDescriptor of(KeyframeId id) const {
    if (!any_) return {};
    SqliteStatement row(connection_,
                        "SELECT kind, descriptor, checksum FROM image WHERE keyframe = ?");
    if (!row.bind(sqlite_id(id)).step()) return {};
    const std::vector<std::uint8_t> stored = row.blob(1);
    if (row.integer(2) != checksum_of(stored)) {
      throw FormatError("the checksum of its image does not fit: it is damaged");
    }
    const ImageKind kind(static_cast<std::uint32_t>(row.integer(0)), stored.size());
    ImageDescriptor::Bytes bytes;
    bytes.reserve(stored.size());
    for (const std::uint8_t byte : stored) bytes.push_back(static_cast<std::int8_t>(byte));
    return ImageDescriptor(kind, std::move(bytes));
  }

 private:
  const SqliteConnection& connection_;
  bool any_;
};

}  // namespace detail
}  // namespace v0
}  // namespace topobag
