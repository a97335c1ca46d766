// SPDX-License-Identifier: MIT
#include <topobag/bag/detail/index/leaf_order.hpp>

#include <algorithm>
#include <random>

#include "catch.hpp"

using namespace topobag;

TEST_CASE("a leaf's bound is the best that a graph of its totals can score", "[bag]") {
  std::mt19937 random(14);
  std::uniform_real_distribution<float> weight(0.0F, 10.0F);
  for (int round = 0; round < 500; ++round) {
    const float common = weight(random), a = common + weight(random), least = weight(random);
    const float greatest = least + weight(random);
    // By the totals b that there may be, and the share of Σ min in them.
    float best = 0.0F;
    for (int i = 0; i <= 200; ++i) {
      const float b = least + (greatest - least) * static_cast<float>(i) / 200.0F;
      const float shared = std::min(common, b);
      if (a + b - shared > 0.0F) best = std::max(best, shared / (a + b - shared));
    }
    const float bound = detail::jaccard_bound(common, a, least, greatest);
    CAPTURE(common, a, least, greatest);
    CHECK(bound >= best - 1e-6F);
    CHECK(bound <= best + 0.01F);
  }
  CHECK(detail::jaccard_bound(0.0F, 0.0F, 0.0F, 0.0F) == 0.0F);
}
