// SPDX-License-Identifier: MIT
#include <cstddef>
#include <random>
#include <vector>

#include <topobag/bag/bag_of_topology_graphs.hpp>
#include <topobag/bag/build_indexed_bag.hpp>

#include "catch.hpp"
#include "matching/layouts.hpp"

using namespace topobag;

TEST_CASE("a built bag answers as one that grew, and as brute force over what it stores",
          "[bag][index]") {
  std::mt19937 random(7);
  BagOfTopologyGraphs<> source;
  for (std::uint64_t id = 0; id < 600; ++id) {
    EntryInfo info;
    info.stamp = 0.4 * static_cast<double>(id);
    source.add(KeyframeId{3 * id}, noisy_graph(random, 3 + id % 7, 4), info);
  }
  const IndexedBag built = build_indexed_bag(source);
  REQUIRE(built.size() == source.size());
  BagOfTopologyGraphs<> stored;
  built.for_each([&](KeyframeId id, const EntryInfo& info, const TopologyGraph<>& graph) {
    CHECK(info.stamp == source.info(id)->stamp);
    stored.add(id, graph, info);
  });
  for (int query = 0; query < 50; ++query) {
    const TopologyGraph<> graph = noisy_graph(random, 6, 4);
    CHECK(built.query(graph) == stored.query(graph));
  }
}

TEST_CASE("an empty bag builds an empty one", "[bag][index]") {
  CHECK(build_indexed_bag(BagOfTopologyGraphs<>{}).empty());
}
