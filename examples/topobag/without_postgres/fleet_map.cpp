// SPDX-License-Identifier: MIT
#include "fleet_map.hpp"

#include "input_error.hpp"

namespace program {
namespace {

[[noreturn]] void refuse() {
  throw InputError("the program was built without libpq and SQLite3; install them, build again");
}

}  // namespace

std::optional<topobag::DescribedCatalog> fleet_map_classes(const std::string&) { refuse(); }

SavedMap read_fleet_map(const std::string&, const ObjectClasses&) { refuse(); }

void extend_fleet_map(const std::string&, const std::string&, const topobag::BagOfTopologyGraphs<>&,
                      const ObjectClasses&) {
  refuse();
}

void prepare_fleet(const FleetAddress&, const ObjectClasses&) { refuse(); }

void admit_to_fleet(const FleetAddress&, const std::string&) { refuse(); }

std::size_t push_to_fleet(const FleetAddress&, const std::string&) { refuse(); }

void follow_fleet(const FleetAddress&, const ObjectClasses&, std::optional<std::chrono::seconds>,
                  const FollowSays&) {
  refuse();
}

std::vector<SiteFigures> fleet_status(const FleetAddress&) { refuse(); }

}  // namespace program
