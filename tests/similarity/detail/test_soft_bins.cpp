// SPDX-License-Identifier: MIT
#include <topobag/similarity/detail/soft_bins.hpp>

#include "catch.hpp"

using namespace topobag;

TEST_CASE("a vote is shared between the two nearest bins", "[similarity]") {
  const auto bins = detail::soft_bins(0.7, 0.2, 5.0);
  CHECK(bins[0].bin == 3);
  CHECK(bins[0].share == Approx(0.5));
  CHECK(bins[1].bin == 4);
  CHECK(bins[1].share == Approx(0.5));

  const auto zero = detail::soft_bins(0.0, 0.2, 5.0);
  CHECK(zero[0].bin == 0);
  CHECK(zero[0].share == 1.0);
  CHECK(zero[1].share == 0.0);

  const auto far = detail::soft_bins(1e308, 0.5, 5.0);
  CHECK(far[0].bin == 10);
  CHECK(far[0].share == 1.0);
}
