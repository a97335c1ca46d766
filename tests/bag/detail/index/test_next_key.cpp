// SPDX-License-Identifier: MIT
#include <cstdint>
#include <iterator>
#include <optional>
#include <random>
#include <set>

#include <topobag/bag/bag_of_topology_graphs.hpp>
#include <topobag/bag/detail/index/next_key.hpp>
#include <topobag/bag/indexed_bag.hpp>

#include "catch.hpp"

using namespace topobag;

TEST_CASE("both bags tell the ids beside any, through adding, erasing and compacting",
          "[bag][index]") {
  std::mt19937 random(2);
  BagOfTopologyGraphs<> bag;
  IndexedBag indexed;
  std::set<KeyframeId> truth;
  const auto check = [&](KeyframeId id) {
    const auto above = truth.upper_bound(id), from = truth.lower_bound(id);
    const std::optional<KeyframeId> after =
        above == truth.end() ? std::nullopt : std::optional(*above);
    const std::optional<KeyframeId> before =
        from == truth.begin() ? std::nullopt : std::optional(*std::prev(from));
    CHECK(bag.after(id) == after);
    CHECK(bag.before(id) == before);
    CHECK(indexed.after(id) == after);
    CHECK(indexed.before(id) == before);
  };
  for (int step = 0; step < 3000; ++step) {
    const KeyframeId id{random() % 900};
    if (truth.insert(id).second) {
      bag.add(id, {});
      indexed.add(id, {});
    } else if (random() % 3 == 0) {
      bag.erase(id);
      indexed.erase(id);
      truth.erase(id);
    }
    if (step % 1000 == 999) indexed.compact();
    if (step % 7 == 0) check(KeyframeId{random() % 1000});
  }
  check(KeyframeId{0});
  check(KeyframeId{~std::uint64_t{0}});
}
