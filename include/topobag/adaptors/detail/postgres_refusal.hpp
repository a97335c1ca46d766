// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <topobag/adaptors/detail/postgres_connection.hpp>
#include <topobag/adaptors/fleet/fleet_version.hpp>
#include <topobag/adaptors/fleet/uuid.hpp>
#include <topobag/error.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// Throws why a server takes no versions: what its word means to the robot.
/// @param server  its name, for people
/// @param key     of the first of them
[[noreturn]] inline void refuse_append(const PostgresRefusal& refusal, const std::string& server,
                                       const FleetKey& key) {
  const std::string site = "site '" + key.site + "'";
  if (refusal.constraint() == "catalog_of_site") {
    throw FormatError(server + ": the classes of " + site +
                      " mean other names than the map's; make the map with those");
  }
  if (refusal.code() == "23514") {
    throw Error(server + ": there is no " + site +
                "; its owner makes it with `topobag fleet init`");
  }
  if (refusal.code() == "42501") {
    throw Error(server + ": this role may not add key frames of robot " + to_text(key.robot) +
                " at " + site + "; the owner admits it with `topobag fleet admit`");
  }
  throw refusal;
}

}  // namespace detail
}  // namespace v0
}  // namespace topobag
