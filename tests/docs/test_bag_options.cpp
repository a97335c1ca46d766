// SPDX-License-Identifier: MIT
// What examples/docs/concepts.md says that a bag may tell beside what it must.
#include <cstddef>
#include <optional>
#include <random>
#include <vector>

#include <topobag/bag/bag_of_topology_graphs.hpp>
#include <topobag/bag/entry_filter.hpp>

#include "catch.hpp"
#include "random_graphs.hpp"

using namespace topobag;

TEST_CASE("concepts: what a bag may tell beside", "[docs]") {
  BagOfTopologyGraphs<> filled;
  std::mt19937 random(1);
  const TopologyGraph<> graph = random_graph(random, 5);
  EntryInfo here;
  here.T_world_camera = Eigen::Isometry3d::Identity();
  filled.add(KeyframeId{7}, graph, here);
  const BagOfTopologyGraphs<>& bag = filled;
  const std::optional<EntryInfo> info = bag.info(KeyframeId{7});
  REQUIRE(info);
  CHECK(info->T_world_camera);
  CHECK(bag.places() == 1);
  const ClassCounts objects = class_counts(graph.nodes());
  const ClassGroups groups;
  CHECK(bag.places_holding(objects, groups) == 1);
  const MapRegion region{Eigen::Vector3d::Zero(), 2.5};
  CHECK(bag.within(region) == std::vector<KeyframeId>{KeyframeId{7}});
}
