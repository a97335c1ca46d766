// SPDX-License-Identifier: MIT
#include <limits>
#include <optional>
#include <random>
#include <vector>

#include <topobag/sensing/dynamic_feature_mask.hpp>

#include "catch.hpp"

using namespace topobag;

namespace {

const ClassCatalog coco = ClassCatalog::coco80();
const RangedDetection walker{{100.0, 100.0, 200.0, 300.0}, coco.at("person"), 0.8, 2.0};
const RangedDetection screen{{300.0, 100.0, 400.0, 200.0}, coco.at("tv"), 0.8, 1.5};

}  // namespace

TEST_CASE("features on a person are masked, the background beside them is kept", "[sensing]") {
  const DynamicFeatureMask mask({walker, screen}, coco);
  const Eigen::Vector2d inside(150.0, 200.0), outside(250.0, 200.0), on_monitor(350.0, 150.0);
  CHECK(mask(inside, 2.0));
  CHECK(mask(inside, 2.5));
  CHECK_FALSE(mask(inside, 2.6));  // the wall behind
  CHECK_FALSE(mask(inside, 1.4));  // something before
  CHECK_FALSE(mask(outside, 2.0));
  CHECK_FALSE(mask(on_monitor, 1.5));
  CHECK_FALSE(mask.empty());
}

TEST_CASE("without depth the whole box is masked", "[sensing]") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const DynamicFeatureMask mask({walker}, coco);
  for (const std::optional<double> z :
       {std::optional<double>(), std::optional<double>(0.0), std::optional<double>(nan)}) {
    CHECK(mask({150.0, 200.0}, z));
    CHECK_FALSE(mask({250.0, 200.0}, z));
  }
  RangedDetection unknown = walker;
  unknown.z = 0.0;
  CHECK(DynamicFeatureMask({unknown}, coco)({150.0, 200.0}, 9.0));
}

TEST_CASE("the paper's sentence masks low dynamics too, at any depth", "[sensing]") {
  const DynamicFeatureMask mask({walker, screen}, coco, DynamicFeatureOptions::paper());
  CHECK(mask({350.0, 150.0}, 1.5));
  CHECK(mask({150.0, 200.0}, 7.0));
  const RangedDetection chair{{300.0, 100.0, 400.0, 200.0}, coco.at("chair"), 0.8, 1.5};
  CHECK(DynamicFeatureMask({chair}, coco, DynamicFeatureOptions::paper()).empty());
}

TEST_CASE("unsure and broken boxes mask nothing, wrong options and classes are told", "[sensing]") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  RangedDetection unsure = walker, broken = walker, scoreless = walker;
  unsure.confidence = 0.2;
  broken.box.x1 = nan;
  scoreless.confidence = nan;
  CHECK(DynamicFeatureMask({unsure, broken, scoreless}, coco).empty());
  CHECK_THROWS_AS(DynamicFeatureMask({walker, {walker.box, ClassId{999}, 0.9, 1.0}}, coco),
                  UnknownClass);
  DynamicFeatureOptions options;
  options.reach = nan;
  CHECK_THROWS_AS(DynamicFeatureMask({walker}, coco, options), InvalidValue);
}

TEST_CASE("many features at once are the same one by one", "[sensing]") {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> u(0.0, 640.0), z(0.5, 4.0);
  const DynamicFeatureMask mask({walker}, coco);
  std::vector<Eigen::Vector2d> pixels;
  for (int i = 0; i < 500; ++i) pixels.emplace_back(u(random), u(random));
  const auto depth = [](const Eigen::Vector2d& pixel) -> std::optional<double> {
    if (pixel.x() < 120.0) return std::nullopt;
    return pixel.y() / 100.0;
  };
  const std::vector<bool> dropped = mask.masked(pixels, depth);
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    CHECK(dropped[i] == mask(pixels[i], depth(pixels[i])));
  }
}

TEST_CASE("a box whose depth is infinite is one of unknown depth", "[sensing][regression]") {
  RangedDetection endless = walker;
  endless.z = std::numeric_limits<double>::infinity();
  CHECK(DynamicFeatureMask({endless}, coco)({150.0, 200.0}, 9.0));
}

TEST_CASE("detections that know no depth mask whole boxes", "[sensing]") {
  const std::vector<Detection> boxes{{walker.box, walker.label, 0.9}};
  const DynamicFeatureMask mask(boxes, coco);
  CHECK(mask(walker.box.center(), 99.0));
  CHECK_FALSE(DynamicFeatureMask({walker}, coco)(walker.box.center(), 99.0));
}
