// SPDX-License-Identifier: MIT
#include <random>
#include <string>

#include <topobag/bag/described_catalog.hpp>

#include "bag/warehouse_catalogs.hpp"
#include "catch.hpp"

using namespace topobag;

TEST_CASE("the first class of which two catalogs say different things is told", "[bag]") {
  const DescribedCatalog map = warehouse();
  CHECK_FALSE(difference(map, warehouse()));
  for (const auto& [other, sentence] : other_warehouses()) {
    REQUIRE(difference(map, other));
    CHECK(*difference(map, other) == sentence);
    CHECK(difference(other, map));
  }
}

TEST_CASE("what a catalog leaves unsaid is not compared", "[bag]") {
  DescribedCatalog names(warehouse().catalog);
  names.catalog.add_alias("truck", "forklift");
  CHECK_FALSE(difference(warehouse(), names));
  CHECK_FALSE(difference(names, warehouse()));
  DescribedCatalog sizes = names;
  sizes.sizes.emplace();
  CHECK(difference(warehouse(), sizes));
  CHECK_FALSE(difference(names, sizes));
  names.catalog.set_dynamics(ClassId{0}, Dynamics::medium);
  CHECK(difference(warehouse(), names));
}

TEST_CASE("look-alikes are the same however they were joined, and of the catalog alone", "[bag]") {
  std::mt19937 random(4);
  for (int round = 0; round < 50; ++round) {
    DescribedCatalog one(ClassCatalog::coco80()), other(ClassCatalog::coco80());
    one.lookalikes.emplace();
    other.lookalikes.emplace();
    std::vector<std::pair<ClassId, ClassId>> pairs;
    for (int i = 0; i < 12; ++i) {
      pairs.emplace_back(ClassId{static_cast<int>(random() % 80)},
                         ClassId{static_cast<int>(random() % 80)});
    }
    for (const auto& [a, b] : pairs) one.lookalikes->join(a, b);
    for (auto pair = pairs.rbegin(); pair != pairs.rend(); ++pair) {
      other.lookalikes->join(pair->second, pair->first);
    }
    one.lookalikes->join(ClassId{-5}, ClassId{3});  // no class of the catalog
    CHECK_FALSE(difference(one, other));
    ClassId alone{0};
    while (!other.lookalikes->compatible(alone, ClassId{3}) &&
           other.lookalikes->members(alone).size() > 1) {
      alone = ClassId{value(alone) + 1};
    }
    if (other.lookalikes->compatible(alone, ClassId{3})) continue;
    other.lookalikes->join(alone, ClassId{3});
    CHECK(difference(one, other));
  }
}
