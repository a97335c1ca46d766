// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include <topobag/adaptors/detail/sqlite_connection.hpp>
#include <topobag/adaptors/detail/sqlite_schema.hpp>
#include <topobag/adaptors/fleet/fleet_outbox.hpp>
#include <topobag/adaptors/fleet/fleet_version.hpp>
#include <topobag/adaptors/fleet/uuid.hpp>
#include <topobag/adaptors/postgres.hpp>

namespace topobag {
inline namespace v0 {

/// Makes an SQLite map an outbox, as `enlist`, once the server has said that it would take the
/// map's key frames. Where it would not, or cannot be asked, this throws as `PostgresStore::append`
/// and leaves the map as it was. A map that is an outbox already is not asked about.
/// @param path  of a map that is there
inline void enlist(const std::string& path, const std::string& site, PostgresStore& store,
                   std::optional<Uuid> robot = std::nullopt) {
  FleetVersion first;  // as the map's would be, but for what it shows
  {
    const detail::SqliteConnection map(path, true);
    detail::prepare_schema(map, true);
    if (detail::member_in(map)) return enlist(path, site, robot);
    first.catalog = static_cast<std::uint64_t>(
        detail::sqlite_number(map, "SELECT value FROM meta WHERE key = 'catalog'"));
  }
  if (!robot) robot = random_uuid();
  first.key = {site, *robot, random_uuid(), KeyframeId{0}};
  first.seq = 1;
  first.tombstone = true;
  store.require_taken(first);
  enlist(path, site, robot);
}

}  // namespace v0
}  // namespace topobag
