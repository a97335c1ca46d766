// SPDX-License-Identifier: MIT
#include <cmath>
#include <optional>
#include <string>

#include <topobag/types/detection.hpp>

#include "catch.hpp"

namespace {

struct ForeignBox {
  float left, top, width, height;
  int category;
  float score;
};

struct RangedBox : ForeignBox {
  double range;
};

struct NoisyBox : RangedBox {
  double sigma;
};

struct WrongLabel {};

struct HeldLabel {
  topobag::ClassId label{};
};

struct NamedBox {
  ForeignBox box;
  float look[2];
};

}  // namespace

template <>
struct topobag::detection_traits<ForeignBox> {
  static BoundingBox box(const ForeignBox& b) {
    return {b.left, b.top, b.left + b.width, b.top + b.height};
  }
  static ClassId label(const ForeignBox& b) { return ClassId{b.category}; }
  static double confidence(const ForeignBox& b) { return b.score; }
};

template <>
struct topobag::detection_traits<RangedBox> : topobag::detection_traits<ForeignBox> {
  static std::optional<double> depth(const RangedBox& b) { return b.range; }
};

template <>
struct topobag::detection_traits<NoisyBox> : topobag::detection_traits<RangedBox> {
  static double depth_deviation(const NoisyBox& b) { return b.sigma; }
};

template <>
struct topobag::detection_traits<WrongLabel> {
  static BoundingBox box(const WrongLabel&) { return {}; }
  static int label(const WrongLabel&) { return 0; }
  static double confidence(const WrongLabel&) { return 0.0; }
};

template <>
struct topobag::detection_traits<HeldLabel> {
  static BoundingBox box(const HeldLabel&) { return {}; }
  static const ClassId& label(const HeldLabel& d) { return d.label; }
  static double confidence(const HeldLabel&) { return 1.0; }
};

template <>
struct topobag::detection_traits<NamedBox> : topobag::detection_traits<ForeignBox> {
  static BoundingBox box(const NamedBox& d) { return detection_traits<ForeignBox>::box(d.box); }
  static ClassId label(const NamedBox& d) { return detection_traits<ForeignBox>::label(d.box); }
  static double confidence(const NamedBox& d) {
    return detection_traits<ForeignBox>::confidence(d.box);
  }
  static Appearance appearance(const NamedBox& d) {
    return Appearance(AppearanceKind("look", 2), Eigen::Vector2f(d.look[0], d.look[1]));
  }
};

using namespace topobag;

static_assert(is_detection_v<Detection>);
static_assert(is_detection_v<ForeignBox> && !is_ranged_detection_v<ForeignBox>);
static_assert(is_detection_v<RangedBox> && is_ranged_detection_v<RangedBox>);
static_assert(!is_detection_v<WrongLabel>, "a label has to be a ClassId, not an int");
static_assert(!is_detection_v<int> && !is_detection_v<std::string>);

TEST_CASE("a foreign struct is read through its traits", "[types]") {
  const ForeignBox foreign{10.0F, 20.0F, 4.0F, 6.0F, 62, 0.5F};
  const BoundingBox box = detection_traits<ForeignBox>::box(foreign);
  CHECK(box.center() == Eigen::Vector2d(12.0, 23.0));
  CHECK(detection_traits<ForeignBox>::label(foreign) == ClassId{62});
  CHECK(detection_traits<ForeignBox>::confidence(foreign) == 0.5);
}

TEST_CASE("the library's own detection is handed out without a copy", "[types]") {
  const Detection detection{{1.0, 2.0, 3.0, 4.0}, ClassId{7}, 0.25};
  CHECK(&detection_traits<Detection>::box(detection) == &detection.box);
  CHECK(detection_traits<Detection>::label(detection) == ClassId{7});
  CHECK(detection_traits<Detection>::confidence(detection) == 0.25);
}

TEST_CASE("a detection may say how well it knows its depth", "[types]") {
  NoisyBox seen{};
  seen.range = 2.0;
  STATIC_REQUIRE(is_ranged_detection_v<NoisyBox>);
  for (const double sigma : {0.25, 1e-9}) {
    seen.sigma = sigma;
    CHECK(depth_deviation_of(seen) == sigma);
  }
  for (const double none : {0.0, -1.0, std::nan(""), HUGE_VAL}) {
    seen.sigma = none;
    CHECK(depth_deviation_of(seen) == 0.0);
  }
  CHECK(depth_deviation_of(static_cast<const RangedBox&>(seen)) == 0.0);
  CHECK(depth_deviation_of(static_cast<const ForeignBox&>(seen)) == 0.0);
}

TEST_CASE("a label may be handed out by reference", "[types][regression]") {
  STATIC_REQUIRE(is_detection_v<HeldLabel>);
}

TEST_CASE("a detection may say what its object looks like", "[types][appearance]") {
  STATIC_REQUIRE(is_detection_v<NamedBox>);
  STATIC_REQUIRE(is_described_detection_v<NamedBox>);
  STATIC_REQUIRE_FALSE(is_described_detection_v<ForeignBox>);
  const NamedBox seen{{10.0F, 20.0F, 4.0F, 6.0F, 62, 0.5F}, {2.0F, -1.0F}};
  CHECK(appearance_of(seen) == Appearance(AppearanceKind("look", 2), Appearance::Bytes{127, -64}));
  CHECK_FALSE(appearance_of(seen.box).known());
}
