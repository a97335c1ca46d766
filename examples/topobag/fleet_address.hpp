// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace program {

/// Where a fleet's map is: an address of PostgreSQL with the sites and the robot in question, as in
/// postgresql://user@host/base?site=hall&site=yard&robot=UUID&sslmode=require.
struct FleetAddress {
  std::string conninfo;            ///< what is libpq's
  std::vector<std::string> sites;  ///< none = all that may be read
  std::string robot;               ///< a UUID; empty = not said
};

/// Whether it is such an address, and no file's path.
bool is_fleet_address(const std::string& text);

/// Throws InputError for what is no such address, and for a password in it, which the process list
/// and every report would show.
FleetAddress parse_fleet_address(const std::string& text);

}  // namespace program
