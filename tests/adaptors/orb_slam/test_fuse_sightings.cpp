// SPDX-License-Identifier: MIT
#include <memory>
#include <random>
#include <vector>

#include <topobag/adaptors/orb_slam/fuse_sightings.hpp>

#include "adaptors/small_host.hpp"
#include "catch.hpp"

using namespace topobag;

TEST_CASE("sightings fuse in the last one's frame, wherever the world is", "[adaptors]") {
  const SyntheticRoom room(3, 8, 5);
  std::mt19937 random(4);
  const Eigen::Isometry3d T_other_world = random_camera(random);
  std::vector<PosedSighting> sightings, moved;
  for (int i = 0; i < 4; ++i) {
    const Eigen::Isometry3d T_world_camera = random_camera(random);
    const auto seen = std::make_shared<const KeyframeSighting>(
        small_host::sighting(room, 0.5 * i, T_world_camera));
    sightings.push_back({seen, T_world_camera});
    moved.push_back({seen, T_other_world * T_world_camera});
  }
  const TopologyGraph<> graph = fuse_sightings(sightings, {});
  const TopologyGraph<> elsewhere = fuse_sightings(moved, {});
  const auto& last = sightings.back().sighting->nodes;
  REQUIRE(graph.size() == last.size());
  REQUIRE(elsewhere.size() == last.size());
  for (std::size_t i = 0; i < last.size(); ++i) {
    CHECK((*graph.nodes()[i].position - *last[i].position).norm() < 1e-9);
    CHECK((*elsewhere.nodes()[i].position - *last[i].position).norm() < 1e-9);
  }
  CHECK(fuse_sightings({}, {}).empty());
}
