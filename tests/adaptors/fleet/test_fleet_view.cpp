// SPDX-License-Identifier: MIT
#include <memory>
#include <random>
#include <vector>

#include <topobag/adaptors/fleet/fleet_view.hpp>
#include <topobag/bag/bag_concepts.hpp>

#include "bag/reading_calls.hpp"
#include "catch.hpp"
#include "random_graphs.hpp"

using namespace topobag;

// Its ids are its own: it is asked, and neither saved nor merged.
static_assert(is_searchable_bag_v<FleetView> && !is_stored_bag_v<FleetView>);
static_assert(!is_growing_bag_v<FleetView> && !is_durable_bag_v<FleetView>);

TEST_CASE("ties go by key, whatever the order of arrival", "[fleet]") {
  std::mt19937 random(1);
  const auto graph = random_graph(random, 6);
  FleetView::Sessions sessions{{"yard", Uuid{1}, Uuid{1}, 0, "later"},
                               {"hall", Uuid{1}, Uuid{1}, 5, "first"}};
  IndexedBag bag;
  for (std::uint64_t session = 0; session < 2; ++session) {
    for (std::uint64_t i = 0; i < 20; ++i) bag.add(KeyframeId{session << 32 | i}, graph);
  }
  const FleetView view(bag.view(), std::make_shared<const FleetView::Sessions>(sessions));
  QueryOptions options;
  options.max_results = 3;
  const auto found = view.query(graph, options);
  REQUIRE(found.size() == 3);
  for (std::uint64_t i = 0; i < 3; ++i) {
    CHECK(view.key(found[i].id) == FleetKey{"hall", Uuid{1}, Uuid{1}, KeyframeId{5ULL << 32 | i}});
  }
  options.max_results = 0;
  CHECK(view.query(graph, options).empty());
  std::vector<FleetKey> keys;
  view.for_each([&](const FleetKey& key, const auto&, const auto&) { keys.push_back(key); });
  REQUIRE(keys.size() == 40);
  CHECK(keys.front().site == "hall");
  CHECK(keys.back().site == "yard");
  CHECK(view.image_kind() == bag.image_kind());
  CHECK(missing_calls_of<FleetView>() == "");
  CHECK_THROWS_AS(view.key(KeyframeId{2ULL << 32}), InvalidId);
}
