// SPDX-License-Identifier: MIT
#include <limits>

#include <topobag/types/bounding_box.hpp>

#include "catch.hpp"

using namespace topobag;

TEST_CASE("eq. 2: the centre of a box is the mean of its corners", "[types][paper]") {
  const BoundingBox box{10.0, 20.0, 30.0, 60.0};
  CHECK(box.center().x() == 20.0);
  CHECK(box.center().y() == 40.0);
  CHECK(box.width() == 20.0);
  CHECK(box.height() == 40.0);
  CHECK(box.area() == 800.0);
}

TEST_CASE("a box needs extent and finite corners", "[types]") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  CHECK(BoundingBox{0, 0, 1, 1}.is_valid());
  CHECK_FALSE(BoundingBox{1, 0, 1, 1}.is_valid());
  CHECK_FALSE(BoundingBox{0, 2, 1, 1}.is_valid());
  CHECK_FALSE(BoundingBox{nan, 0, 1, 1}.is_valid());
  CHECK_FALSE(BoundingBox{0, 0, inf, 1}.is_valid());
}

TEST_CASE("clipping keeps what lies over the image's pixels", "[types]") {
  const BoundingBox clipped = BoundingBox{-20, 10, 700, 500}.clipped(640, 480);
  CHECK(clipped.x1 == -0.5);
  CHECK(clipped.y1 == 10.0);
  CHECK(clipped.x2 == 639.5);
  CHECK(clipped.y2 == 479.5);
  CHECK_FALSE(BoundingBox{-20, 10, -5, 50}.clipped(640, 480).is_valid());
}

TEST_CASE("intersection over union on hand-computed boxes", "[types]") {
  const BoundingBox a{0, 0, 2, 2};
  CHECK(intersection_over_union(a, a) == 1.0);
  CHECK(intersection_over_union(a, {1, 1, 3, 3}) == Approx(1.0 / 7.0));
  CHECK(intersection_over_union(a, {2, 0, 3, 1}) == 0.0);
}

TEST_CASE("a box around a centre has that centre, width and height", "[types]") {
  const BoundingBox box = box_around({100.0, 50.0}, 30.0, 8.0);
  CHECK(box.x1 == 85.0);
  CHECK(box.y1 == 46.0);
  CHECK(box.x2 == 115.0);
  CHECK(box.y2 == 54.0);
}

TEST_CASE("a box contains its border", "[types]") {
  const BoundingBox box{10.0, 20.0, 30.0, 60.0};
  CHECK(box.contains({10.0, 20.0}));
  CHECK(box.contains({30.0, 60.0}));
  CHECK_FALSE(box.contains({30.1, 40.0}));
  CHECK_FALSE(box.contains({20.0, 19.9}));
}

TEST_CASE("a box that comes near the image's border is cut by it", "[types]") {
  const auto is_cut = [](const BoundingBox& box) { return box.is_cut(640.0, 480.0); };
  CHECK_FALSE(is_cut({2.0, 2.0, 637.0, 477.0}));
  CHECK(is_cut({1.9, 2.0, 637.0, 477.0}));
  CHECK(is_cut({2.0, 1.9, 637.0, 477.0}));
  CHECK(is_cut({2.0, 2.0, 637.1, 477.0}));
  CHECK(is_cut({2.0, 2.0, 637.0, 477.1}));
  CHECK(is_cut({-5.0, 100.0, 60.0, 200.0}));  // beyond it, too
}
