// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>

#include <topobag/matching/chance_model.hpp>
#include <topobag/matching/scale_range.hpp>

#include "catch.hpp"

using namespace topobag;

TEST_CASE("a range of scales has a width and holds what is between its ends", "[matching]") {
  const ScaleRange range{0.5, 2.0};
  CHECK(range.log_width() == Approx(std::log(4.0)));
  for (const double scale : {0.5, 1.0, 2.0}) CHECK(range.contains(scale));
  for (const double scale : {0.49, 2.01, 0.0, std::numeric_limits<double>::quiet_NaN()}) {
    CHECK_FALSE(range.contains(scale));
  }
}

TEST_CASE("a range of scales that is none is refused", "[matching]") {
  const double infinity = std::numeric_limits<double>::infinity();
  for (const ScaleRange& range : {ScaleRange{0.0, 1.0}, ScaleRange{-1.0, 1.0}, ScaleRange{2.0, 1.0},
                                  ScaleRange{1.0, 1.0}, ScaleRange{1.0, infinity}}) {
    CHECK_THROWS_AS(range.log_width(), InvalidValue);
  }
}

TEST_CASE("a chosen scale costs how many of the range can be told apart", "[matching]") {
  // The share of the range that a Gaussian posterior fills, integrated by sums.
  const ScaleRange range{0.25, 4.0};
  for (const double deviation : {0.01, 0.03, 0.1}) {
    double filled = 0.0;
    const double step = 1e-4;
    for (double x = -1.0; x < 1.0; x += step) {
      filled += step * std::exp(-0.5 * x * x / (deviation * deviation));
    }
    CHECK(ChanceModel::log10_scale_cost(range, deviation) ==
          Approx(std::log10(range.log_width() / filled)).epsilon(1e-3));
  }
  CHECK(ChanceModel::log10_scale_cost(range, 0.03) == Approx(1.57).margin(0.01));
  CHECK(ChanceModel::log10_scale_cost(range, 50.0) == 0.0);  // nothing was chosen
}
