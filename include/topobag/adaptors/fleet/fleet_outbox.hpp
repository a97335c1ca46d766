// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <topobag/adaptors/detail/outbox_schema.hpp>
#include <topobag/adaptors/detail/sqlite_connection.hpp>
#include <topobag/adaptors/detail/sqlite_images.hpp>
#include <topobag/adaptors/detail/sqlite_row.hpp>
#include <topobag/adaptors/detail/sqlite_schema.hpp>
#include <topobag/adaptors/detail/sqlite_statement.hpp>
#include <topobag/adaptors/fleet/fleet_version.hpp>
#include <topobag/adaptors/fleet/uuid.hpp>
#include <topobag/adaptors/sqlite.hpp>
#include <topobag/bag/detail/storage/entry_record.hpp>
#include <topobag/bag/graph_codec.hpp>
#include <topobag/error.hpp>
#include <topobag/types/utf8.hpp>

namespace topobag {
inline namespace v0 {

/// A robot of a fleet, and where it maps.
struct FleetMember {
  std::string site;  ///< its name
  Uuid robot{};      ///< for ever the same

  /// Throws InvalidValue for a site without a name, or one that is not UTF-8.
  void validate() const {
    require_utf8(site, "the site's name");
    if (site.empty() || site.find('\0') != std::string::npos) {
      throw InvalidValue("a site has a name, without zero letters");
    }
  }
};

namespace detail {

inline Uuid uuid_of(const std::vector<std::uint8_t>& bytes) {
  Uuid uuid{};
  if (bytes.size() != uuid.size()) throw FormatError("a UUID in the map is not of 16 bytes");
  std::copy(bytes.begin(), bytes.end(), uuid.begin());
  return uuid;
}

inline std::optional<FleetMember> member_in(const SqliteConnection& map) {
  if (sqlite_number(map, "SELECT count(*) FROM sqlite_master WHERE name = 'fleet_member'") == 0) {
    return std::nullopt;
  }
  SqliteStatement member(map, "SELECT site, robot FROM fleet_member");
  member.step();
  return FleetMember{member.text(0), uuid_of(member.blob(1))};
}

}  // namespace detail

/// Makes an SQLite map, new or not, an outbox: from then on it numbers its changes, and robot and
/// site are kept with it. A map that is one already is left as it is. Before the `SqliteBag` is
/// opened that goes on with it. Throws InvalidId when the map is another member's, and as
/// `SqliteBag`.
/// @param robot  where none is named: the map's own, or a new one for a map that has none
inline void enlist(const std::string& path, const std::string& site,
                   const std::optional<Uuid>& robot = std::nullopt) {
  const detail::SqliteConnection map(path, false);
  detail::prepare_schema(map, false);
  detail::SqliteTransaction transaction(map);
  if (const auto known = detail::member_in(map)) {
    if (known->site == site && known->robot == robot.value_or(known->robot)) return;
    throw InvalidId(path + ": it is the map of robot " + to_text(known->robot) + " at site '" +
                    known->site + "'; give this one a map of its own");
  }
  const FleetMember member{site, robot.value_or(random_uuid())};
  member.validate();
  map.run(detail::outbox_schema);
  detail::SqliteStatement(map, "INSERT INTO fleet_member VALUES (?, ?)")
      .bind(member.site, std::vector<std::uint8_t>(member.robot.begin(), member.robot.end()))
      .step();
  transaction.commit();
}

/// What a robot's map has to tell the fleet, read beside the `SqliteBag` that writes it. The map
/// works without a server for as long as it takes; changes of one key frame meanwhile are told as
/// the last of them.
class FleetOutbox {
 public:
  /// Throws FormatError for a map that was not enlisted, and as `SqliteBag` to read.
  explicit FleetOutbox(const std::string& path) : map_(path, true) {
    detail::prepare_schema(map_, true);
    const auto member = detail::member_in(map_);
    if (!member) throw FormatError(path + ": the map belongs to no fleet; enlist it first");
    member_ = *member;
    catalog_ = static_cast<std::uint64_t>(
        detail::sqlite_number(map_, "SELECT value FROM meta WHERE key = 'catalog'"));
  }

  /// Whose map it is, and of which site.
  const FleetMember& member() const noexcept { return member_; }
  /// The file's.
  const std::string& path() const noexcept { return map_.path(); }

  /// Of all sessions that have had a key frame.
  std::vector<Uuid> sessions() const {
    std::vector<Uuid> sessions;
    detail::SqliteStatement rows(map_, "SELECT uuid FROM fleet_session ORDER BY session");
    while (rows.step()) sessions.push_back(detail::uuid_of(rows.blob(0)));
    return sessions;
  }

  /// The number of the last change; 0 = none.
  std::int64_t last_seq() const {
    return detail::sqlite_number(map_, "SELECT coalesce(max(seq), 0) FROM fleet_change");
  }

  /// Key frames that changed after the change `seq`. O(changes).
  std::size_t count_after(std::int64_t seq) const {
    detail::SqliteStatement count(map_, "SELECT count(*) FROM fleet_change WHERE seq > ?");
    count.bind(seq).step();
    return static_cast<std::size_t>(count.integer(0));
  }

  /// The next changes after the change `seq`, in order. Throws FormatError for a damaged map.
  std::vector<FleetVersion> after(std::int64_t seq, std::size_t max_versions) const {
    std::vector<FleetVersion> versions;
    detail::SqliteStatement rows(map_, detail::outbox_select);
    rows.bind(seq, static_cast<std::int64_t>(max_versions));
    const detail::SqliteImages images(map_);
    while (rows.step()) versions.push_back(version_of(rows, images));
    return versions;
  }

 private:
  FleetVersion version_of(const detail::SqliteStatement& row,
                          const detail::SqliteImages& images) const {
    FleetVersion version;
    version.key = {member_.site, member_.robot, detail::uuid_of(row.blob(15)),
                   KeyframeId{static_cast<std::uint64_t>(row.integer(14))}};
    version.seq = row.integer(13);
    version.run = row.text(16);
    version.catalog = catalog_;
    version.tombstone = row.is_null(0);
    if (version.tombstone) return version;
    const detail::EntryRecord entry = detail::read_row(row);
    version.stamp = entry.info.stamp;
    version.label = entry.info.label;
    if (entry.info.T_world_camera) {
      version.pose.emplace();  // as it is written: a matrix would round it once more
      for (int i = 0; i < 7; ++i) (*version.pose)[std::size_t(i)] = row.number(4 + i).value();
    }
    version.graph = entry.graph;
    version.image = images.of(version.key.keyframe);
    version.appearance = decode(entry.graph).appearance_kind();
    return version;
  }

  detail::SqliteConnection map_;
  FleetMember member_;
  std::uint64_t catalog_ = 0;
};

}  // namespace v0
}  // namespace topobag
