// SPDX-License-Identifier: MIT
#include <limits>
#include <optional>
#include <vector>

#include <topobag/sensing/range_detections.hpp>

#include "catch.hpp"

using namespace topobag;

TEST_CASE("every detection gets the depth in its box, clipped to the image", "[sensing]") {
  const PinholeCamera<> camera{100.0, 100.0, 50.0, 50.0, 100, 100};
  // The left half is 1 m away, the right 2 m, below the middle nothing is measured.
  const auto depth = [](const Eigen::Vector2d& pixel) -> std::optional<double> {
    if (pixel.y() > 50.0 || pixel.x() < 0.0) return std::nullopt;
    return pixel.x() < 50.0 ? 1.0 : 2.0;
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<Detection> detections{{{10.0, 10.0, 20.0, 20.0}, ClassId{1}, 0.5},
                                          {{60.0, 10.0, 80.0, 40.0}, ClassId{2}, 0.6},
                                          {{10.0, 60.0, 20.0, 80.0}, ClassId{3}, 0.7},
                                          {{-90.0, 10.0, 20.0, 20.0}, ClassId{4}, 0.8},
                                          {{nan, 10.0, 20.0, 20.0}, ClassId{5}, 0.9}};
  const auto ranged = range_detections(detections, depth, camera);
  REQUIRE(ranged.size() == detections.size());
  const double expected[] = {1.0, 2.0, 0.0, 1.0, 0.0};
  for (std::size_t i = 0; i < ranged.size(); ++i) {
    CHECK(ranged[i].z == expected[i]);
    CHECK(ranged[i].label == detections[i].label);
    CHECK(ranged[i].confidence == detections[i].confidence);
  }
  CHECK(ranged[3].box.x1 == -0.5);
}

TEST_CASE("a depth that is no distance counts as none", "[sensing]") {
  const PinholeCamera<> camera{100.0, 100.0, 50.0, 50.0, 0, 0};
  const std::vector<Detection> detections{{{10.0, 10.0, 20.0, 20.0}, ClassId{1}, 0.5}};
  for (const double z :
       {-1.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    const auto depth = [&](const Eigen::Vector2d&) { return std::optional<double>(z); };
    CHECK(range_detections(detections, depth, camera, CenterDepth{})[0].z == 0.0);
  }
}

TEST_CASE("a sampling policy may give a plain number", "[sensing]") {
  const PinholeCamera<> camera{100.0, 100.0, 50.0, 50.0, 0, 0};
  const std::vector<Detection> detections{{{10.0, 10.0, 20.0, 20.0}, ClassId{1}, 0.5}};
  const auto wall = [](const Eigen::Vector2d&) { return std::optional<double>(2.0); };
  const auto half = [](const auto& depth, const BoundingBox& box) {
    return *depth(box.center()) / 2.0;
  };
  CHECK(range_detections(detections, wall, camera, half)[0].z == 1.0);
}

TEST_CASE("what an object looks like and may be is kept with its depth", "[sensing]") {
  const PinholeCamera<> camera{100.0, 100.0, 50.0, 50.0, 100, 100};
  RangedDetection cup{{10.0, 10.0, 20.0, 20.0}, ClassId{1}, 0.5, 0.0, {}, {}};
  cup.appearance = Appearance(AppearanceKind("a", 2), Appearance::Bytes{1, 2});
  cup.label_weights = LabelWeights({{ClassId{1}, 1.0}, {ClassId{2}, 0.5}});
  const auto far = [](const Eigen::Vector2d&) -> std::optional<double> { return 2.0; };
  const auto ranged = range_detections(std::vector<RangedDetection>{cup}, far, camera);
  REQUIRE(ranged.size() == 1);
  CHECK(ranged[0].z == 2.0);
  CHECK(ranged[0].appearance == cup.appearance);
  CHECK(ranged[0].label_weights == cup.label_weights);
}
