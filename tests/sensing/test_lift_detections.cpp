// SPDX-License-Identifier: MIT
#include <limits>
#include <list>
#include <optional>
#include <random>
#include <vector>

#include <topobag/sensing/lift_detections.hpp>

#include "catch.hpp"

namespace {

/// A detection as of a front end that knows depths.
struct DetectionWithDepth {
  topobag::Detection detection;
  std::optional<double> z;
};

}  // namespace

template <>
struct topobag::detection_traits<DetectionWithDepth> {
  static const BoundingBox& box(const DetectionWithDepth& d) { return d.detection.box; }
  static ClassId label(const DetectionWithDepth& d) { return d.detection.label; }
  static double confidence(const DetectionWithDepth& d) { return d.detection.confidence; }
  static std::optional<double> depth(const DetectionWithDepth& d) { return d.z; }
};

using namespace topobag;

namespace {

const PinholeCamera<> camera{500.0, 400.0, 320.0, 240.0, 640, 480};
const ClassCatalog catalog = ClassCatalog::coco80();
const ClassId tv = catalog.at("tv");
const ClassId person = catalog.at("person");
const double not_a_number = std::numeric_limits<double>::quiet_NaN();

std::optional<double> two_metres(const Eigen::Vector2d&) { return 2.0; }

/// What a single detection is dropped for; nothing when it becomes a node.
DroppedDetections dropped(const Detection& detection, std::optional<double> z = 2.0,
                          const LiftOptions& options = {}) {
  const std::vector<DetectionWithDepth> one{{detection, z}};
  const auto lifted = lift_detections(one, camera, catalog, options);
  CHECK(lifted.nodes.size() + lifted.dropped.total() == 1);
  return lifted.dropped;
}

}  // namespace

TEST_CASE("eq. 1, 2 and 5 on a hand-computed detection", "[sensing][paper]") {
  const std::vector<Detection> detections{{{400.0, 100.0, 440.0, 180.0}, tv, 0.8}};
  const auto lifted = lift_detections(detections, two_metres, camera, catalog, {}, CenterDepth{});
  REQUIRE(lifted.nodes.size() == 1);
  const SemanticNode<>& node = lifted.nodes[0];
  CHECK(*node.pixel == Eigen::Vector2d(420.0, 140.0));           // eq. 2
  CHECK(node.z == 2.0);                                          // eq. 1
  CHECK(node.label == tv);                                       // eq. 1
  CHECK(*node.position == Eigen::Vector3d(0.4, -0.5, 2.0));      // eq. 5
  CHECK(node.size.isApprox(Eigen::Vector2d(0.16, 0.4), 1e-12));  // 40 px and 80 px at 2 m
  CHECK(node.confidence == 0.8);
  CHECK(node.existence == 1.0);
  CHECK(node.covariance == NodeNoise{}.covariance(*node.position, node.size, false));
  CHECK(lifted.sources == std::vector<std::size_t>{0});
  CHECK(lifted.dropped.total() == 0);
}

TEST_CASE("a depth of its own stands in for a depth source", "[sensing]") {
  const Detection detection{{400.0, 100.0, 440.0, 180.0}, tv, 0.8};
  const auto sampled =
      lift_detections(std::vector<Detection>{detection}, two_metres, camera, catalog);
  const auto ranged =
      lift_detections(std::vector<DetectionWithDepth>{{detection, 2.0}}, camera, catalog);
  REQUIRE(ranged.nodes.size() == 1);
  CHECK(*ranged.nodes[0].position == *sampled.nodes[0].position);
  CHECK(ranged.nodes[0].covariance == sampled.nodes[0].covariance);
}

TEST_CASE("nodes keep the order of their detections and point back at them", "[sensing]") {
  std::list<Detection> detections;  // any range will do
  for (int i = 0; i < 6; ++i) {
    const double x = 50.0 + 90.0 * i;
    detections.push_back({{x, 100.0, x + 40.0, 140.0}, i % 2 == 0 ? tv : person, 0.9});
  }
  const auto lifted = lift_detections(detections, two_metres, camera, catalog);
  CHECK(lifted.sources == std::vector<std::size_t>{0, 2, 4});
  CHECK(lifted.dropped.dynamic == 3);
  for (std::size_t i = 0; i + 1 < lifted.nodes.size(); ++i) {
    CHECK(lifted.nodes[i].pixel->x() < lifted.nodes[i + 1].pixel->x());
  }
}

TEST_CASE("each reason to drop a detection is counted as itself", "[sensing]") {
  const BoundingBox box{100.0, 100.0, 200.0, 200.0};
  const double inf = std::numeric_limits<double>::infinity();
  CHECK(dropped({box, tv, 0.9}).total() == 0);

  CHECK(dropped({{not_a_number, 100.0, 200.0, 200.0}, tv, 0.9}).invalid == 1);
  CHECK(dropped({{100.0, 100.0, inf, 200.0}, tv, 0.9}).invalid == 1);
  CHECK(dropped({{200.0, 100.0, 100.0, 200.0}, tv, 0.9}).invalid == 1);
  CHECK(dropped({{100.0, 100.0, 100.0, 200.0}, tv, 0.9}).invalid == 1);
  CHECK(dropped({{700.0, 100.0, 800.0, 200.0}, tv, 0.9}).invalid == 1);  // beside the image
  CHECK(dropped({box, tv, not_a_number}).invalid == 1);
  CHECK(dropped({box, tv, 0.29}).low_confidence == 1);
  CHECK(dropped({box, person, 0.9}).dynamic == 1);
  CHECK(dropped({{0.0, 0.0, 639.0, 400.0}, tv, 0.9}).too_large == 1);
  CHECK(dropped({box, tv, 0.9}, std::nullopt).no_depth == 1);
  CHECK(dropped({box, tv, 0.9}, not_a_number).no_depth == 1);
  CHECK(dropped({box, tv, 0.9}, inf).no_depth == 1);
  CHECK(dropped({box, tv, 0.9}, 0.0).out_of_range == 1);
  CHECK(dropped({box, tv, 0.9}, 0.09).out_of_range == 1);
  CHECK(dropped({box, tv, 0.9}, 10.1).out_of_range == 1);

  // The first reason counts.
  CHECK(dropped({box, person, 0.1}, std::nullopt).low_confidence == 1);
  CHECK(dropped({{0.0, 0.0, 639.0, 400.0}, person, 0.9}, std::nullopt).dynamic == 1);
  CHECK(dropped({{0.0, 0.0, 639.0, 400.0}, tv, 0.9}, std::nullopt).too_large == 1);
}

TEST_CASE("which levels of dynamics stay is the caller's choice", "[sensing]") {
  const BoundingBox box{100.0, 100.0, 200.0, 200.0};
  LiftOptions everything;
  everything.keep = {Dynamics::low, Dynamics::medium, Dynamics::high};
  CHECK(dropped({box, person, 0.9}, 2.0, everything).total() == 0);
  LiftOptions low;
  low.keep = {Dynamics::low};
  CHECK(dropped({box, catalog.at("chair"), 0.9}, 2.0, low).dynamic == 1);
  CHECK(dropped({box, tv, 0.9}, 2.0, low).total() == 0);
}

TEST_CASE("the ends of the range of depths belong to it", "[sensing]") {
  const Detection screen{{100.0, 100.0, 200.0, 200.0}, tv, 0.9};
  for (const double z : {LiftOptions{}.min_depth, LiftOptions{}.max_depth}) {
    CHECK(dropped(screen, z).total() == 0);
  }
}

TEST_CASE("of two detections that are one object the surer one is kept", "[sensing]") {
  const BoundingBox box{100.0, 100.0, 200.0, 200.0};
  const std::vector<Detection> twins{{box, tv, 0.6}, {box, catalog.at("laptop"), 0.9}};
  const auto lifted = lift_detections(twins, two_metres, camera, catalog);
  REQUIRE(lifted.nodes.size() == 1);
  CHECK(lifted.nodes[0].label == catalog.at("laptop"));
  CHECK(lifted.sources == std::vector<std::size_t>{1});
  CHECK(lifted.dropped.duplicate == 1);
}

TEST_CASE("a box is clipped to the image before its centre is taken", "[sensing]") {
  const std::vector<Detection> cut{{{600.0, 100.0, 700.0, 200.0}, tv, 0.9}};
  const auto lifted = lift_detections(cut, two_metres, camera, catalog);
  REQUIRE(lifted.nodes.size() == 1);
  CHECK(lifted.nodes[0].pixel->x() == 619.75);  // of 600 … 639.5
  CHECK(lifted.nodes[0].covariance ==
        NodeNoise{}.covariance(*lifted.nodes[0].position, lifted.nodes[0].size, true));

  PinholeCamera<> no_size = camera;
  no_size.width = no_size.height = 0;
  const auto whole = lift_detections(cut, two_metres, no_size, catalog);
  REQUIRE(whole.nodes.size() == 1);
  CHECK(whole.nodes[0].pixel->x() == 650.0);
}

TEST_CASE("a class that the catalog does not hold is an error with its index", "[sensing]") {
  const BoundingBox box{100.0, 100.0, 200.0, 200.0};
  const std::vector<Detection> detections{{box, tv, 0.9}, {box, ClassId{80}, 0.9}};
  try {
    lift_detections(detections, two_metres, camera, catalog);
    FAIL("nothing was thrown");
  } catch (const UnknownClass& error) {
    CHECK(error.index() == 1U);
    CHECK(std::string(error.what()) ==
          "detection 1 has class id 80, which the catalog does not hold: add it, or have "
          "detection_traits number classes as the catalog does");
  }
}

TEST_CASE("a bad camera is refused even when there is nothing to lift", "[sensing]") {
  CHECK_THROWS_AS(lift_detections(std::vector<Detection>{}, two_metres, PinholeCamera<>{}, catalog),
                  InvalidValue);
}

TEST_CASE("no detections, no nodes", "[sensing]") {
  const auto lifted = lift_detections(std::vector<Detection>{}, two_metres, camera, catalog);
  CHECK(lifted.nodes.empty());
  CHECK(lifted.dropped.total() == 0);
}

TEMPLATE_TEST_CASE("a box that overflows does not become a node of NaN", "[sensing][regression]",
                   float, double) {
  PinholeCamera<TestType> no_size = camera.cast<TestType>();
  no_size.width = no_size.height = 0;
  const double big = 1e300;
  const std::vector<Detection> detections{{{-big, -big, big, big}, tv, 0.9},
                                          {{0.9e308, 0.0, 1.7e308, 1.0}, tv, 0.9}};
  const auto lifted = lift_detections(detections, two_metres, no_size, catalog);
  CHECK(lifted.nodes.empty());
  CHECK(lifted.dropped.invalid == 2);
}

TEMPLATE_TEST_CASE("ten thousand detections, broken ones among them: all accounted for, no NaN",
                   "[sensing]", float, double) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> u(-100.0, 740.0);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  std::vector<DetectionWithDepth> detections;
  for (int i = 0; i < 10000; ++i) {
    BoundingBox box =
        box_around({u(random), u(random)}, 400.0 * unit(random), 300.0 * unit(random));
    if (i % 7 == 0) box.x1 = not_a_number;
    const double score = i % 11 == 0 ? not_a_number : unit(random);
    const std::optional<double> z =
        i % 5 == 0 ? std::optional<double>() : std::optional<double>(12.0 * unit(random));
    detections.push_back({{box, ClassId{i % 80}, score}, i % 13 == 0 ? not_a_number : z});
  }
  const auto lifted = lift_detections(detections, camera.cast<TestType>(), catalog);
  CHECK(lifted.nodes.size() + lifted.dropped.total() == detections.size());
  CHECK(lifted.nodes.size() > 1000);
  for (const auto& node : lifted.nodes) {
    REQUIRE(node.position);
    REQUIRE(node.pixel);
    CHECK(node.position->allFinite());
    CHECK(node.covariance.allFinite());
    CHECK(node.pixel->x() <= TestType(639.5));
    CHECK(node.z >= TestType(0.1));
    CHECK(node.z <= TestType(10));
  }
}
