// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include <topobag/adaptors/detail/postgres_connection.hpp>
#include <topobag/adaptors/detail/postgres_rows.hpp>
#include <topobag/adaptors/detail/postgres_refusal.hpp>
#include <topobag/adaptors/fleet/fleet_version.hpp>
#include <topobag/adaptors/fleet/uuid.hpp>
#include <topobag/error.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// Adds those of the versions that the server lacks, within the caller's transaction. Returns how
/// many. Throws as `PostgresStore::append`. Precondition: there is one.
inline std::size_t append_versions(PostgresConnection& server,
                                   const std::vector<FleetVersion>& versions) {
  std::size_t added = 0;
  try {
    added = server.run(postgres_append, row_parameters(versions)).changed();
  } catch (const PostgresRefusal& refusal) {
    refuse_append(refusal, server.name(), versions.front().key);
  }
  if (added < versions.size() &&
      server.run(postgres_contradicted, name_parameters(versions)).integer(0, 0) > 0) {
    throw InvalidId(server.name() + ": robot " + to_text(versions.front().key.robot) +
                    " has other key frames there under the same numbers: a copy of the map " +
                    "is in use; give one of them a new map");
  }
  return added;
}

}  // namespace detail
}  // namespace v0
}  // namespace topobag
