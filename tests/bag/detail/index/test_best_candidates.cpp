// SPDX-License-Identifier: MIT
#include <topobag/bag/detail/index/best_candidates.hpp>

#include "catch.hpp"

using namespace topobag;

TEST_CASE("a score within the rounding of the k best may still be one of them", "[bag]") {
  const double slack = detail::score_slack;
  detail::BestCandidates best(2, 0.1);
  CHECK(best.wants(0.1));
  CHECK_FALSE(best.wants(0.1 - 2.0 * slack));
  best.add({}, {}, 0.7);
  CHECK(best.wants(0.1));  // there is room for a second
  best.add({}, {}, 0.5);
  best.add({}, {}, 0.3);
  CHECK(best.floor() == 0.5 - slack);
  // Two scores, each off by the slack.
  CHECK(best.wants(0.5 - 1.9 * slack));
  CHECK_FALSE(best.wants(0.5 - 2.1 * slack));
}
