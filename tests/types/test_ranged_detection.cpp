// SPDX-License-Identifier: MIT
#include <topobag/types/ranged_detection.hpp>

#include "catch.hpp"

using namespace topobag;

static_assert(is_ranged_detection_v<RangedDetection>);

TEST_CASE("a ranged detection without depth has none", "[types]") {
  using Traits = detection_traits<RangedDetection>;
  CHECK_FALSE(Traits::depth({{0.0, 0.0, 1.0, 1.0}, ClassId{1}, 0.5, 0.0}));
  CHECK(Traits::depth({{0.0, 0.0, 1.0, 1.0}, ClassId{1}, 0.5, 2.0}) == 2.0);
}
