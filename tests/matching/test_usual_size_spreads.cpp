// SPDX-License-Identifier: MIT
#include <topobag/matching/usual_size_spreads.hpp>

#include "catch.hpp"

using namespace topobag;

TEST_CASE("usual sizes go by the names of classes, not by their numbers", "[matching]") {
  const auto coco = usual_size_spreads(ClassCatalog::coco80());
  CHECK(coco.size() == detail::usual_size_spreads.size());
  ClassCatalog own;
  const ClassId chair{7};
  own.add(chair, "chair", Dynamics::medium);
  own.add(ClassId{8}, "forklift", Dynamics::high);
  const auto spreads = usual_size_spreads(own);
  REQUIRE(spreads.size() == 1);
  const ClassId coco_chair = *ClassCatalog::coco80().find("chair");
  CHECK(spreads.at(chair).within == coco.at(coco_chair).within);
}

TEST_CASE("chairs differ more in height than keyboards in width, as one sees them", "[matching]") {
  const ClassCatalog catalog = ClassCatalog::coco80();
  const auto spreads = usual_size_spreads(catalog);
  CHECK(spreads.at(*catalog.find("chair")).within[1] >
        spreads.at(*catalog.find("keyboard")).within[0]);
  for (const auto& [label, spread] : spreads) {
    for (const double side : spread.within) CHECK((side > 0.05 && side < 1.0));
    for (const double side : spread.between) CHECK((side > 0.05 && side < 1.0));
  }
}
