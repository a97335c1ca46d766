// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include <topobag/adaptors/detail/sqlite_statement.hpp>
#include <topobag/bag/described_catalog.hpp>
#include <topobag/bag/detail/storage/crc32.hpp>
#include <topobag/bag/detail/storage/entry_record.hpp>
#include <topobag/bag/entry_info.hpp>
#include <topobag/error.hpp>
#include <topobag/graph/topology_graph.hpp>
#include <topobag/types/rigid_motion.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

// A 64-bit id and SQLite's signed integer hold each other's bits.
inline std::int64_t sqlite_id(KeyframeId id) { return static_cast<std::int64_t>(value(id)); }

/// Throws FormatError for what is no session's number.
inline std::uint32_t sqlite_session(double number) {
  const bool fits = number >= 0.0 && number <= std::numeric_limits<std::uint32_t>::max();
  if (!fits || number != std::floor(number))
    throw FormatError("its session is no whole number of 32 bits");
  return static_cast<std::uint32_t>(number);
}

inline std::int64_t checksum_of(const std::vector<std::uint8_t>& bytes) {
  return static_cast<std::int64_t>(crc32(bytes.data(), bytes.size()));
}

/// The pose as a translation and a unit quaternion x, y, z, w.
inline std::vector<std::optional<double>> pose_columns(
    const std::optional<Eigen::Isometry3d>& T_world_camera) {
  if (!T_world_camera) return std::vector<std::optional<double>>(7);
  const Eigen::Vector3d t = T_world_camera->translation();
  const Eigen::Quaterniond q(T_world_camera->linear());
  return {t.x(), t.y(), t.z(), q.x(), q.y(), q.z(), q.w()};
}

/// Throws InvalidValue as `pose_from_numbers`.
inline Eigen::Isometry3d pose_of(const std::vector<std::optional<double>>& columns) {
  std::array<double, 7> numbers{};
  for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = columns[i].value_or(0.0);
  return pose_from_numbers(numbers);
}

/// "1 keyboard, 2 tv": for people.
template <typename Scalar>
std::string objects_in(const TopologyGraph<Scalar>& graph,
                       const std::optional<DescribedCatalog>& classes) {
  std::map<std::string, std::size_t> counts;
  for (const auto& node : graph.nodes()) {
    const bool known = classes && classes->catalog.contains(node.label);
    ++counts[known ? classes->catalog.name(node.label)
                   : "class " + std::to_string(value(node.label))];
  }
  std::string text;
  for (const auto& [name, count] : counts) {
    text += (text.empty() ? "" : ", ") + std::to_string(count) + ' ' + name;
  }
  return text;
}

inline constexpr const char* sqlite_insert =
    "INSERT INTO keyframe(session, stamp, label, tx, ty, tz, qx, qy, qz, qw, nodes, edges, objects,"
    " graph, checksum, id) VALUES(?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)";
inline constexpr const char* sqlite_update =
    "UPDATE keyframe SET session = ?, stamp = ?, label = ?, tx = ?, ty = ?, tz = ?, qx = ?, qy = ?,"
    " qz = ?, qw = ?, nodes = ?, edges = ?, objects = ?, graph = ?, checksum = ? WHERE id = ?";
inline constexpr const char* sqlite_move =
    "UPDATE keyframe SET tx = ?, ty = ?, tz = ?, qx = ?, qy = ?, qz = ?, qw = ? WHERE id = ?";
inline constexpr const char* sqlite_select =
    "SELECT id, session, stamp, label, tx, ty, tz, qx, qy, qz, qw, graph, checksum FROM keyframe"
    " ORDER BY id";
inline constexpr const char* sqlite_select_one =
    "SELECT id, session, stamp, label, tx, ty, tz, qx, qy, qz, qw, graph, checksum FROM keyframe"
    " WHERE id = ?";

/// Runs `sqlite_insert` or `sqlite_update` for an entry whose decoded graph is `graph`.
template <typename Scalar>
void write_row(SqliteStatement& statement, const EntryRecord& entry,
               const TopologyGraph<Scalar>& graph, const std::optional<DescribedCatalog>& classes) {
  const auto pose = pose_columns(entry.info.T_world_camera);
  const std::string objects = objects_in(graph, classes);
  statement.bind(std::int64_t{entry.info.session}, entry.info.stamp, entry.info.label, pose[0],
                 pose[1], pose[2], pose[3], pose[4], pose[5], pose[6],
                 static_cast<std::int64_t>(graph.size()),
                 static_cast<std::int64_t>(graph.edges().size()), objects, entry.graph,
                 checksum_of(entry.graph), sqlite_id(entry.id));
  statement.step();
}

/// The row where a `sqlite_select` stands. Throws FormatError when its graph is damaged or a number
/// is none, InvalidValue for a pose that is none: who edits a map by hand hears of it.
inline EntryRecord read_row(const SqliteStatement& row) {
  EntryRecord entry;
  entry.id = KeyframeId{static_cast<std::uint64_t>(row.integer(0))};
  entry.info.session = sqlite_session(row.number(1).value_or(-1.0));
  entry.info.stamp = row.number(2);
  entry.info.label = row.text(3);
  std::vector<std::optional<double>> pose;
  for (int column = 4; column < 11; ++column) pose.push_back(row.number(column));
  const auto given = std::count_if(pose.begin(), pose.end(), [](auto& x) { return x.has_value(); });
  if (given != 0 && given != 7)
    throw FormatError("its pose is not whole: tx to qw are seven numbers");
  if (given == 7) entry.info.T_world_camera = pose_of(pose);
  entry.graph = row.blob(11);
  if (row.integer(12) != checksum_of(entry.graph)) {
    throw FormatError("its checksum does not fit: it is damaged");
  }
  return entry;
}

}  // namespace detail
}  // namespace v0
}  // namespace topobag
