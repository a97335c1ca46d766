// SPDX-License-Identifier: MIT
#include <limits>
#include <vector>

#include <topobag/sensing/non_maximum_suppression.hpp>

#include "catch.hpp"

using namespace topobag;

TEST_CASE("non-maximum suppression stays within a class", "[sensing]") {
  const BoundingBox box{0.0, 0.0, 10.0, 10.0};
  const BoundingBox shifted{2.0, 0.0, 12.0, 10.0};  // IoU 2/3
  const BoundingBox beside{8.0, 0.0, 18.0, 10.0};   // IoU 1/9
  const std::vector<Detection> kept = suppress_non_maxima({{shifted, ClassId{1}, 0.5},
                                                           {beside, ClassId{1}, 0.4},
                                                           {box, ClassId{1}, 0.9},
                                                           {shifted, ClassId{2}, 0.3}},
                                                          0.45);
  REQUIRE(kept.size() == 3);
  CHECK(kept[0].confidence == 0.9);
  CHECK(kept[1].confidence == 0.4);
  CHECK(kept[2].label == ClassId{2});
}

TEST_CASE("a score that is not a number suppresses nothing", "[sensing][regression]") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const BoundingBox box{0.0, 0.0, 10.0, 10.0};
  const std::vector<Detection> kept =
      suppress_non_maxima({{box, ClassId{1}, nan}, {box, ClassId{1}, 0.9}}, 0.45);
  REQUIRE(kept.size() == 1);
  CHECK(kept[0].confidence == 0.9);
}

namespace {

struct SomeonesBox {
  float x, y, side;
  int kind;
  float probability;
};

}  // namespace

template <>
struct topobag::detection_traits<SomeonesBox> {
  static BoundingBox box(const SomeonesBox& b) {
    return box_around({static_cast<double>(b.x), static_cast<double>(b.y)},
                      static_cast<double>(b.side), static_cast<double>(b.side));
  }
  static ClassId label(const SomeonesBox& b) { return ClassId{b.kind}; }
  static double confidence(const SomeonesBox& b) { return static_cast<double>(b.probability); }
};

TEST_CASE("a detector's own boxes are suppressed as they are", "[sensing]") {
  const std::vector<SomeonesBox> kept = suppress_non_maxima(
      std::vector<SomeonesBox>{{11, 10, 10, 1, 0.5F}, {10, 10, 10, 1, 0.9F}, {11, 10, 10, 2, 0.4F}},
      0.45);
  REQUIRE(kept.size() == 2);
  CHECK(kept[0].probability == 0.9F);
  CHECK(kept[1].kind == 2);
}
