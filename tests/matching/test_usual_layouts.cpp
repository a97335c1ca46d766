// SPDX-License-Identifier: MIT
#include <cstddef>

#include <topobag/matching/usual_layouts.hpp>

#include "catch.hpp"

using namespace topobag;

namespace {

std::size_t pairs_in(const LayoutPrior& prior) {
  std::size_t pairs = 0;
  prior.for_each([&](ClassId, ClassId, const DistanceCounts&, const DistanceCounts&) { ++pairs; });
  return pairs;
}

}  // namespace

TEST_CASE("usual layouts go by the names of classes, not by their numbers", "[matching]") {
  const ClassCatalog coco = ClassCatalog::coco80();
  const LayoutPrior prior = usual_layouts(coco);
  CHECK(pairs_in(prior) == detail::usual_layouts.size());
  ClassCatalog own;
  own.add(ClassId{7}, "mouse", Dynamics::high);
  own.add(ClassId{3}, "keyboard", Dynamics::high);
  own.add(ClassId{8}, "forklift", Dynamics::high);
  const LayoutPrior few = usual_layouts(own);
  CHECK((pairs_in(few) >= 1 && pairs_in(few) <= 3));
  // A mouse lies nearer to a keyboard than anything does to anything.
  const double beside = few.density(ClassId{7}, ClassId{3}, 0.35, 3.0, true);
  CHECK(beside > few.density(ClassId{7}, ClassId{8}, 0.35, 3.0, true));
  CHECK(beside > 5.0 * few.density(ClassId{7}, ClassId{3}, 2.5, 3.0, true));
}
