// SPDX-License-Identifier: MIT
#include <cstddef>
#include <cstdint>

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
  std::size_t bytes = 0;
  bag.for_each([&](KeyframeId, const EntryInfo&, const TopologyGraph<>& graph) {
    bytes += encode(graph).size();
  });
  CHECK(usage.graphs >= bytes);
  CHECK(usage.graphs < bytes + 300 * 32);
  CHECK(usage.index > 0);
  CHECK(IndexedBag{}.memory_usage().total() < 1000);
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
