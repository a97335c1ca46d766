// SPDX-License-Identifier: MIT
#include <limits>
#include <vector>

#include <topobag/sensing/range_detections.hpp>
#include <topobag/sensing/sparse_depth.hpp>

#include "catch.hpp"

using namespace topobag;

static_assert(is_depth_source_v<SparseDepth>);

TEST_CASE("a pixel has the depth of the nearest point within reach", "[sensing]") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const SparseDepth depth({{{10.0, 10.0}, 1.0},
                           {{14.0, 10.0}, 2.0},
                           {{10.0, 10.0}, 3.0},
                           {{50.0, nan}, 1.0},
                           {{50.0, 50.0}, -1.0}},
                          5.0);
  CHECK(depth.points().size() == 3);
  CHECK(depth({10.5, 10.0}) == 1.0);
  CHECK(depth({13.0, 10.0}) == 2.0);
  CHECK(depth({10.0, 15.0}) == 1.0);
  CHECK_FALSE(depth({10.0, 15.1}));
  CHECK_FALSE(depth({50.0, 50.0}));
}

TEST_CASE("a box has the depth of the object's points, not of the wall's", "[sensing]") {
  std::vector<DepthPoint> points;
  for (int i = 0; i < 6; ++i) points.push_back({{100.0 + 5.0 * i, 120.0}, 1.5 + 0.01 * i});
  for (int i = 0; i < 9; ++i) points.push_back({{95.0 + 5.0 * i, 110.0}, 4.0});
  points.push_back({{115.0, 115.0}, 0.4});  // one that is astray
  const SparseDepth depth(points);
  const std::vector<Detection> detections{{{80.0, 80.0, 160.0, 160.0}, ClassId{1}, 0.9},
                                          {{300.0, 80.0, 340.0, 160.0}, ClassId{1}, 0.9},
                                          {{112.0, 112.0, 118.0, 118.0}, ClassId{1}, 0.9}};
  const PinholeCamera<> camera{500.0, 500.0, 320.0, 240.0, 640, 480};
  const auto ranged = range_detections(detections, depth, camera, SparseBoxDepth{});
  CHECK(ranged[0].z == Approx(1.53));
  CHECK(ranged[1].z == 0.0);
  CHECK(ranged[2].z == 0.0);  // one point is too few
}

TEST_CASE("a pixel or a radius that is not a number has no depth", "[sensing][regression]") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<DepthPoint> points{{{10.0, 10.0}, 1.0}, {{14.0, 10.0}, 2.0}};
  CHECK_FALSE(SparseDepth(points)({nan, 10.0}));
  CHECK_FALSE(SparseDepth(points, nan)({10.0, 10.0}));
}
