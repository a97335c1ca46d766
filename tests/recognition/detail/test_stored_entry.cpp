// SPDX-License-Identifier: MIT
#include <topobag/recognition/detail/stored_entry.hpp>

#include <cstddef>
#include <optional>
#include <random>
#include <type_traits>
#include <vector>

#include <topobag/bag/bag_of_topology_graphs.hpp>
#include <topobag/bag/indexed_bag.hpp>
#include <topobag/recognition/explain.hpp>
#include <topobag/recognition/relocalizer.hpp>

#include "catch.hpp"
#include "random_graphs.hpp"

using namespace topobag;

namespace {

template <typename Bag>
void check_stored_graph() {
  std::mt19937 random(1);
  const TopologyGraph<> graph = random_graph(random, 5);
  Bag bag;
  bag.add(KeyframeId{1}, graph);
  const auto found = detail::stored_graph(bag, KeyframeId{1}, 0);
  REQUIRE(found);
  CHECK(found->size() == graph.size());
  CHECK_FALSE(detail::stored_graph(bag, KeyframeId{2}, 0));
}

/// A bag of one's own that lends its one graph, and counts the copies that are asked for.
struct LendingBag {
  using Graph = TopologyGraph<>;
  Graph graph;
  mutable std::size_t copies = 0;
  std::vector<Candidate> query(const Graph&, const QueryOptions&) const {
    return {{KeyframeId{1}, 1.0}};
  }
  std::optional<Graph> find(KeyframeId id) const {
    ++copies;
    return id == KeyframeId{1} ? std::make_optional(graph) : std::nullopt;
  }
  std::optional<EntryInfo> info(KeyframeId id) const {
    return id == KeyframeId{1} ? std::make_optional<EntryInfo>() : std::nullopt;
  }
  const Graph* peek(KeyframeId id) const { return id == KeyframeId{1} ? &graph : nullptr; }
};

}  // namespace

TEST_CASE("a graph is read in place where the bag keeps it, else as it is found", "[recognition]") {
  check_stored_graph<BagOfTopologyGraphs<>>();
  check_stored_graph<IndexedBag>();
  const BagOfTopologyGraphs<> bag;
  STATIC_REQUIRE(std::is_pointer_v<decltype(detail::stored_graph(bag, KeyframeId{}, 0))>);
}

TEST_CASE("a bag of one's own that lends its graphs is asked for no copy", "[recognition]") {
  std::mt19937 random(2);
  const LendingBag bag{random_graph(random, 10, 5)};
  const Relocalizer relocalizer(bag);
  const Recognition found = relocalizer.localize(bag.graph);
  REQUIRE(found);
  const Explanation told =
      explain(found, bag, bag.graph, ClassCatalog::coco80(), relocalizer.options());
  REQUIRE(told.candidates.size() == 1);
  CHECK(told.candidates[0].matched.size() == found.accepted->pose->inliers.size());
  CHECK(bag.copies == 0);
}
