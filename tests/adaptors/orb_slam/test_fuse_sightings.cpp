// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <random>
#include <vector>

#include <topobag/adaptors/orb_slam/fuse_sightings.hpp>
#include <topobag/graph/scaled_graph.hpp>

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

TEST_CASE("the host's word on gravity goes before the sighting's", "[adaptors][gravity]") {
  auto seen = std::make_shared<KeyframeSighting>();
  PosedSighting alone{seen};
  CHECK_FALSE(fuse_sightings({alone}, {}).gravity());
  seen->gravity = Gravity<>{{0, 0, 1}, 0.03};
  CHECK(fuse_sightings({alone}, {}).gravity()->down == Eigen::Vector3d::UnitZ());
  alone.gravity = Gravity<>{{0, 1, 0}, 0.02};
  CHECK(fuse_sightings({alone}, {}).gravity()->down == Eigen::Vector3d::UnitY());
  CHECK(fuse_sightings({alone}, {}).gravity()->deviation == Approx(0.02));
}

TEST_CASE("gravity of several key frames falls together", "[adaptors][gravity]") {
  std::mt19937 random(5);
  std::vector<PosedSighting> sightings;
  for (int i = 0; i < 4; ++i) {
    auto seen = std::make_shared<KeyframeSighting>();
    seen->stamp = 0.5 * i;
    const Eigen::Isometry3d T_world_camera = random_camera(random);
    const Eigen::Vector3d down = T_world_camera.linear().row(1);
    sightings.push_back({std::move(seen), T_world_camera, Gravity<>{down, 0.02}});
  }
  const TopologyGraph<> graph = fuse_sightings(sightings, {});
  REQUIRE(graph.gravity());
  CHECK(graph.gravity()->down.isApprox(sightings.back().gravity->down, 1e-9));
  CHECK(graph.gravity()->deviation == Approx(0.02 * std::sqrt(0.625)));
}

TEST_CASE("sightings and poses in one unit fuse in it, whatever it is", "[adaptors]") {
  const SyntheticRoom room(3, 8, 5);
  for (const double factor : {0.7, 1.6}) {
    std::mt19937 random(4);
    std::vector<PosedSighting> in_metres, in_units;
    for (int i = 0; i < 4; ++i) {
      Eigen::Isometry3d T_world_camera = random_camera(random);
      KeyframeSighting seen = small_host::sighting(room, 0.5 * i, T_world_camera);
      in_metres.push_back({std::make_shared<const KeyframeSighting>(seen), T_world_camera});
      seen.nodes = scaled(TopologyGraph<>(seen.nodes, {}), factor).nodes();
      T_world_camera.translation() *= factor;
      in_units.push_back({std::make_shared<const KeyframeSighting>(seen), T_world_camera});
    }
    const TopologyGraph<> expected = scaled(fuse_sightings(in_metres, {}), factor);
    const TopologyGraph<> graph = fuse_sightings(in_units, {});
    REQUIRE(graph.size() == expected.size());
    for (std::size_t i = 0; i < graph.size(); ++i) {
      CHECK((*graph.nodes()[i].position - *expected.nodes()[i].position).norm() < 1e-9);
    }
    // The poses alone in another unit: what was seen before stands elsewhere.
    for (std::size_t i = 0; i < in_units.size(); ++i) in_units[i].sighting = in_metres[i].sighting;
    const TopologyGraph<> mixed = fuse_sightings(in_units, {});
    double off = 0.0;
    const auto& last = in_metres.back().sighting->nodes;
    for (std::size_t i = 0; i < std::min(mixed.size(), last.size()); ++i) {
      off = std::max(off, (*mixed.nodes()[i].position - *last[i].position).norm());
    }
    CHECK(off > 0.02);
  }
}
