// SPDX-License-Identifier: MIT
#include <topobag/recognition/detail/stored_entry.hpp>

#include <random>
#include <type_traits>

#include <topobag/bag/bag_of_topology_graphs.hpp>
#include <topobag/bag/indexed_bag.hpp>

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

}  // namespace

TEST_CASE("a graph is read in place where the bag keeps it, else as it is found", "[recognition]") {
  check_stored_graph<BagOfTopologyGraphs<>>();
  check_stored_graph<IndexedBag>();
  const BagOfTopologyGraphs<> bag;
  STATIC_REQUIRE(std::is_pointer_v<decltype(detail::stored_graph(bag, KeyframeId{}, 0))>);
}
