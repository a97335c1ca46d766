// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <topobag/bag/bag_of_topology_graphs.hpp>
#include <topobag/bag/described_catalog.hpp>

#include "fleet_address.hpp"
#include "object_classes.hpp"
#include "saved_map.hpp"

// What the program asks a fleet's servers. Each call throws topobag::Error, and InputError where
// the program was built without libpq; FormatError where a site says something else of its classes.
namespace program {

/// What the first of the address' sites that says so keeps of its classes.
std::optional<topobag::DescribedCatalog> fleet_map_classes(const std::string& address);

/// The key frames of the address' sites, by site, robot, session and number.
SavedMap read_fleet_map(const std::string& address, const ObjectClasses& classes);

/// Adds a session of a robot to the address' site: whole, or not at all.
void extend_fleet_map(const std::string& address, const std::string& session,
                      const topobag::BagOfTopologyGraphs<>& entries, const ObjectClasses& classes);

/// Prepares the data base, and makes those of the address' sites that are not there. Throws
/// InputError for one that is there with other classes than a file says.
void prepare_fleet(const FleetAddress& address, const ObjectClasses& classes);

/// Lets a role read the address' sites, and write there as the address' robot where it names one.
/// Throws InputError for a role that the server does not have.
void admit_to_fleet(const FleetAddress& address, const std::string& role);

/// Sends what the server lacks of an SQLite map, which becomes the fleet's by that: where the
/// server refuses it, the map stays as it was. Returns how many versions were added.
std::size_t push_to_fleet(const FleetAddress& address, const std::string& map);

/// What following a fleet says while it goes on.
struct FollowSays {
  std::function<void(const std::string&)> count;    ///< how much there is, when that has changed
  std::function<void(const std::string&)> trouble;  ///< what could not be asked or taken
};

/// Follows the address' sites and tells how many key frames of how many sessions there are,
/// whenever that changes, and why a server cannot be asked, until the time is up; without one, for
/// ever. Throws InputError for a site that the server does not have and where not one key frame
/// could be taken, Error where no server could be asked till the end.
void follow_fleet(const FleetAddress& address, const ObjectClasses& classes,
                  std::optional<std::chrono::seconds> time, const FollowSays& says);

/// What a server holds of a site.
struct SiteFigures {
  std::string name;
  std::size_t versions = 0;
  std::size_t robots = 0;
};
/// Of the address' sites, or of all that may be read where it names none. Throws InputError for a
/// site that the server does not have.
std::vector<SiteFigures> fleet_status(const FleetAddress& address);

}  // namespace program
