// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <topobag/adaptors/detail/postgres_parameters.hpp>
#include <topobag/adaptors/detail/postgres_result.hpp>
#include <topobag/adaptors/fleet/fleet_version.hpp>
#include <topobag/bag/detail/storage/crc32.hpp>
#include <topobag/error.hpp>
#include <topobag/types/appearance.hpp>
#include <topobag/types/ids.hpp>
#include <topobag/types/image_descriptor.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

// A 64-bit id and PostgreSQL's signed integer hold each other's bits.
inline std::int64_t postgres_id(KeyframeId id) { return static_cast<std::int64_t>(value(id)); }

/// A kind of descriptors in one number.
inline std::int64_t appearance_number(AppearanceKind kind) {
  return static_cast<std::int64_t>(std::uint64_t{kind.number()} << 8 | kind.length());
}
/// Throws InvalidValue for the number of no kind.
inline AppearanceKind appearance_of(std::uint64_t number) {
  const auto length = static_cast<std::size_t>(number & 0xFF);
  return length == 0 ? AppearanceKind() : AppearanceKind(std::uint32_t(number >> 8), length);
}

/// Of all that a version says of its key frame: two of one name and another content differ here.
inline std::int64_t checksum_of(const FleetVersion& version) {
  std::string content = postgres_bytes(version.tombstone) +
                        postgres_bytes(postgres_id(version.key.keyframe)) +
                        postgres_bytes(version.stamp.value_or(0.0)) + version.label;
  if (version.pose) {
    for (const double x : *version.pose) content += postgres_bytes(x);
  }
  content.append(version.graph.begin(), version.graph.end());
  return std::int64_t{crc32(reinterpret_cast<const std::uint8_t*>(content.data()), content.size())};
}

/// Of an image's kind and numbers; nothing where it is unknown.
inline std::optional<std::int64_t> checksum_of(const ImageDescriptor& image) {
  if (!image.known()) return std::nullopt;
  std::string content = postgres_bytes(std::int64_t{image.kind().number()});
  content.append(image.bytes().begin(), image.bytes().end());
  return std::int64_t{crc32(reinterpret_cast<const std::uint8_t*>(content.data()), content.size())};
}

inline constexpr const char* postgres_append =
    "INSERT INTO topobag.version(site, robot, session, seq, checksum, image_checksum, keyframe, "
    "run,"
    " stamp, label, tx, ty, tz, qx, qy, qz, qw, graph, catalog, appearance, tombstone, image_kind,"
    " image) SELECT * FROM unnest($1, $2, $3, $4, $5, $6, $7, $8, $9, $10, $11, $12, $13, $14, $15,"
    " $16, $17, $18, $19, $20, $21, $22, $23) ON CONFLICT DO NOTHING";
/// Which of them the server holds with another content, of the parameters that name them. An image
/// on one side alone is none: it was pushed by who knew nothing of images.
inline constexpr const char* postgres_contradicted =
    "SELECT count(*) FROM unnest($1, $2, $3, $4, $5, $6)"
    " AS ours(site, robot, session, seq, checksum, image_checksum)"
    " JOIN topobag.version AS theirs USING (site, robot, session, seq)"
    " WHERE theirs.checksum <> ours.checksum OR theirs.image_checksum <> ours.image_checksum";
inline constexpr const char* postgres_read =
    "SELECT arrival, robot, session, seq, keyframe, run, stamp, label, tx, ty, tz, qx, qy, qz, qw,"
    " graph, catalog, appearance, checksum, tombstone, image_kind, image, image_checksum"
    " FROM topobag.version"
    " WHERE site = $1 AND arrival >= $2 AND arrival < pg_snapshot_xmin(pg_current_snapshot())"
    " AND (arrival, robot, session, seq) > ($2, $3, $4, $5)"
    " ORDER BY arrival, robot, session, seq LIMIT $6";

/// What names versions, and their checksums.
inline PostgresParameters name_parameters(const std::vector<FleetVersion>& versions) {
  PostgresParameters parameters;
  parameters.add_array(postgres_text, versions, [](const auto& v) { return v.key.site; })
      .add_array(postgres_uuid, versions, [](const auto& v) { return v.key.robot; })
      .add_array(postgres_uuid, versions, [](const auto& v) { return v.key.session; })
      .add_array(postgres_int8, versions, [](const auto& v) { return v.seq; })
      .add_array(postgres_int8, versions, [](const auto& v) { return checksum_of(v); })
      .add_array(postgres_int8, versions, [](const auto& v) { return checksum_of(v.image); });
  return parameters;
}

/// The parameters of `postgres_append`.
inline PostgresParameters row_parameters(const std::vector<FleetVersion>& versions) {
  PostgresParameters parameters = name_parameters(versions);
  const auto bytes = [](const std::string& text) { return text; };
  parameters
      .add_array(postgres_int8, versions, [](const auto& v) { return postgres_id(v.key.keyframe); })
      .add_array(postgres_bytea, versions, [&](const auto& v) { return bytes(v.run); })
      .add_array(postgres_float8, versions, [](const auto& v) { return v.stamp; })
      .add_array(postgres_bytea, versions, [&](const auto& v) { return bytes(v.label); });
  for (std::size_t i = 0; i < 7; ++i) {
    parameters.add_array(postgres_float8, versions, [i](const FleetVersion& v) {
      return v.pose ? std::optional<double>((*v.pose)[i]) : std::nullopt;
    });
  }
  parameters.add_array(postgres_bytea, versions, [](const auto& v) { return v.graph; })
      .add_array(postgres_int8, versions,
                 [](const auto& v) { return static_cast<std::int64_t>(v.catalog); })
      .add_array(postgres_int8, versions,
                 [](const auto& v) { return appearance_number(v.appearance); })
      .add_array(postgres_bool, versions, [](const auto& v) { return v.tombstone; })
      .add_array(postgres_int8, versions,
                 [](const auto& v) {
                   return v.image.known() ? std::optional<std::int64_t>(v.image.kind().number())
                                          : std::nullopt;
                 })
      .add_array(postgres_bytea, versions, [](const auto& v) {
        using Bytes = std::vector<std::uint8_t>;
        return v.image.known()
                   ? std::optional<Bytes>(Bytes(v.image.bytes().begin(), v.image.bytes().end()))
                   : std::nullopt;
      });
  return parameters;
}

/// The image of a row of `postgres_read`. Throws FormatError and InvalidValue for what is damaged.
inline ImageDescriptor read_image(const PostgresResult& rows, int row) {
  if (rows.is_null(row, 21)) return {};
  const std::vector<std::uint8_t> stored = rows.bytes(row, 21);
  const ImageKind kind(static_cast<std::uint32_t>(rows.bits(row, 20)), stored.size());
  ImageDescriptor::Bytes bytes;
  bytes.reserve(stored.size());
  for (const std::uint8_t byte : stored) bytes.push_back(static_cast<std::int8_t>(byte));
  ImageDescriptor image(kind, std::move(bytes));
  if (rows.integer(row, 22) == checksum_of(image)) return image;
  throw FormatError("the checksum of its image does not fit: it is damaged");
}

/// A row of `postgres_read` of a site. Throws FormatError for what is damaged.
inline FleetVersion read_version(const PostgresResult& rows, int row, const std::string& site) {
  FleetVersion version;
  version.key = {site, rows.uuid(row, 1), rows.uuid(row, 2), KeyframeId{rows.bits(row, 4)}};
  version.seq = rows.integer(row, 3);
  version.run = rows.text(row, 5);
  version.stamp = rows.number(row, 6);
  version.label = rows.text(row, 7);
  if (!rows.is_null(row, 8)) {
    version.pose.emplace();
    for (int i = 0; i < 7; ++i) {
      const double missing = std::numeric_limits<double>::quiet_NaN();  // which no pose holds
      (*version.pose)[std::size_t(i)] = rows.number(row, 8 + i).value_or(missing);
    }
  }
  version.graph = rows.bytes(row, 15);
  version.catalog = rows.bits(row, 16);
  version.appearance = appearance_of(rows.bits(row, 17));
  version.tombstone = rows.flag(row, 19);
  version.image = read_image(rows, row);
  return version;
}

/// The same, or as much of it as could be read and why it is damaged.
inline ReadVersion read_row(const PostgresResult& rows, int row, const std::string& site) {
  ReadVersion read;
  try {
    read.version = read_version(rows, row, site);
    if (checksum_of(read.version) != rows.integer(row, 18)) {
      read.fault = "its checksum does not fit: it is damaged";
    }
  } catch (const Error& error) {
    read.version.key = {site, rows.uuid(row, 1), rows.uuid(row, 2), KeyframeId{rows.bits(row, 4)}};
    read.version.seq = rows.integer(row, 3);
    read.fault = error.what();
  }
  return read;
}

}  // namespace detail
}  // namespace v0
}  // namespace topobag
