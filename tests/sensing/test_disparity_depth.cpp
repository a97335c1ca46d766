// SPDX-License-Identifier: MIT
#include <cstdint>
#include <limits>
#include <optional>

#include <topobag/sensing/depth_view.hpp>
#include <topobag/sensing/disparity_depth.hpp>

#include "catch.hpp"

using namespace topobag;

TEST_CASE("depth is focal length times baseline by disparity", "[sensing]") {
  // A disparity image in sixteenths of a pixel.
  const std::uint16_t disparities[] = {160, 0, 320, 16};
  const DisparityDepth depth(DepthView<std::uint16_t>(disparities, 2, 2, 16.0), 500.0, 0.1);
  static_assert(is_depth_source_v<decltype(depth)>);
  CHECK(*depth({0.0, 0.0}) == Approx(5.0));
  CHECK_FALSE(depth({1.0, 0.0}));
  CHECK(*depth({0.0, 1.0}) == Approx(2.5));
  CHECK(*depth({1.0, 1.0}) == Approx(50.0));
  CHECK_FALSE(depth({5.0, 1.0}));
}

TEST_CASE("disparities and cameras that are none give no depth", "[sensing]") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double bad : {-1.0, nan, std::numeric_limits<double>::infinity()}) {
    const auto disparity = [&](const Eigen::Vector2d&) { return std::optional<double>(bad); };
    CHECK_FALSE(DisparityDepth(disparity, 500.0, 0.1)({0.0, 0.0}));
    CHECK_THROWS_AS(DisparityDepth(disparity, bad, 0.1), InvalidValue);
  }
}

TEST_CASE("disparities of OpenCV's matchers are read as they are, signed and in sixteenths",
          "[sensing][regression]") {
  const std::int16_t disparities[] = {160, -16, 320, 16};  // -1 px = no match
  const DisparityDepth depth(DepthView<std::int16_t>(disparities, 2, 2, 16.0), 500.0, 0.1);
  CHECK(*depth({0.0, 0.0}) == Approx(5.0));
  CHECK_FALSE(depth({1.0, 0.0}));
  CHECK(*depth({0.0, 1.0}) == Approx(2.5));
}
