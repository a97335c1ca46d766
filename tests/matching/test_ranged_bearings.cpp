// SPDX-License-Identifier: MIT
#include <random>

#include <topobag/matching/ranged_bearings.hpp>

#include "catch.hpp"
#include "recognition/bearings_of.hpp"
#include "recognition/synthetic_room.hpp"

using namespace topobag;

TEST_CASE("bearings at one range keep their directions, classes and angular sizes", "[matching]") {
  std::mt19937 random(3);
  const TopologyGraph<> seen = SyntheticRoom(5, 9, 4).seen_from(random_camera(random));
  const BearingSighting sighting = bearings_of(seen, random, 0.02);
  const TopologyGraph<> graph = ranged_bearings<>(sighting, 2.5);
  REQUIRE(graph.size() == seen.size());
  for (std::size_t i = 0; i < graph.size(); ++i) {
    const auto& node = graph.nodes()[i];
    const Bearing& bearing = sighting.bearings[i];
    CHECK(node.label == bearing.label);
    CHECK(node.position->isApprox(2.5 * bearing.direction, 1e-12));
    CHECK(node.size.isApprox(node.z * bearing.extent, 1e-12));
  }
}

TEST_CASE("a pose gives the matched bearings their objects' ranges, and no others", "[matching]") {
  std::mt19937 random(4);
  const SyntheticRoom room(6, 8, 4);
  for (int round = 0; round < 20; ++round) {
    const Eigen::Isometry3d a = random_camera(random), b = random_camera(random);
    const TopologyGraph<> candidate = room.seen_from(a), seen = room.seen_from(b);
    const BearingSighting sighting = bearings_of(seen, random, 0.0);
    RelativePose pose;
    pose.T_candidate_query = a.inverse() * b;
    for (std::size_t i = 0; i < seen.size(); i += 2) {
      pose.inliers.push_back({NodeIndex(i), NodeIndex(i)});
    }
    const TopologyGraph<> graph = ranged_bearings(sighting, candidate, pose);
    REQUIRE(graph.size() == seen.size());
    for (std::size_t i = 0; i < graph.size(); ++i) {
      const auto& position = graph.nodes()[i].position;
      REQUIRE(position.has_value() == (i % 2 == 0));
      if (position) CHECK(position->isApprox(*seen.nodes()[i].position, 1e-9));
    }
  }
}
