// SPDX-License-Identifier: MIT
#include <cstddef>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include <topobag/bag/memory_usage.hpp>

#include "bag/desk_pieces.hpp"
#include "bag/filled_bags.hpp"
#include "catch.hpp"

using namespace topobag;

TEST_CASE("memory is counted by what it is for", "[bag][index]") {
  RecombinedGraphs source(desk_pieces(10), 10);
  const IndexedBag bag = bag_of(source, 30);
  const MemoryUsage usage = bag.view()->memory_usage();
  CHECK(usage.total() == usage.graphs + usage.index + usage.entries);
  std::size_t bytes = 0, nodes = 0;
  bag.for_each([&](KeyframeId, const EntryInfo&, const TopologyGraph<>& graph) {
    bytes += encode(graph).size();
    nodes += graph.size();
  });
  CHECK(usage.nodes == nodes);
  CHECK(usage.graphs >= bytes);
  CHECK(usage.graphs < bytes + 300 * 32);
  CHECK(usage.index > 0);
  CHECK(IndexedBag{}.memory_usage().total() < 1000);
}

TEST_CASE("what a node takes is told, and grows by the length of its descriptor", "[bag][index]") {
  CHECK(IndexedBag{}.memory_usage().bytes_per_node() == 0.0);
  const AppearanceKind kind("test", 24);
  IndexedBag without, with;
  RecombinedGraphs source(desk_pieces(10), 10);
  bag_of(source, 50).for_each([&](KeyframeId id, const EntryInfo&, const TopologyGraph<>& graph) {
    std::vector<SemanticNode<>> nodes = graph.nodes();
    for (auto& node : nodes) node.appearance = Appearance(kind, Eigen::VectorXd::Ones(24));
    without.add(id, graph);
    with.add(id, TopologyGraph<>(nodes, graph.edges(), graph.views()));
  });
  for (std::uint64_t i = 0; i < 500; i += 7) {
    without.erase(KeyframeId{i});
    with.erase(KeyframeId{i});
  }
  without.compact();
  with.compact();
  const MemoryUsage plain = without.memory_usage(), described = with.memory_usage();
  std::size_t nodes = 0;
  with.for_each(
      [&](KeyframeId, const EntryInfo&, const TopologyGraph<>& graph) { nodes += graph.size(); });
  CHECK(plain.nodes == nodes);
  CHECK(described.nodes == nodes);
  CHECK(plain.bytes_per_node() ==
        Approx(static_cast<double>(plain.total()) / static_cast<double>(nodes)));
  // 24 bytes, a bit, and the kind once a graph.
  const double more = described.bytes_per_node() - plain.bytes_per_node();
  CHECK(more > 24.0);
  CHECK(more < 26.0);
}

TEST_CASE("room comes back", "[bag][index]") {
  RecombinedGraphs source(desk_pieces(6), 6);
  IndexedBag bag = bag_of(source, 200);
  const std::size_t full = bag.memory_usage().total();
  CHECK(bag.memory_usage().graphs / bag.size() < 150);
  for (std::uint64_t i = 0; i < 2000; ++i) {
    if (i % 10 != 0) bag.erase(KeyframeId{i});
  }
  CHECK(bag.size() == 200);
  CHECK(bag.memory_usage().total() < full / 2);
  bag.compact();
  CHECK(bag.memory_usage().total() < full / 3);
  for (std::uint64_t i = 0; i < 2000; i += 10) CHECK(bag.contains(KeyframeId{i}));
  for (std::uint64_t i = 0; i < 2000; i += 10) bag.erase(KeyframeId{i});
  CHECK(bag.empty());
  CHECK(bag.memory_usage().total() < 1000);
}
