// SPDX-License-Identifier: MIT
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include <topobag/graph/sight_keyframe.hpp>
#include <topobag/graph/topology_graph.hpp>

#include "catch.hpp"

using namespace topobag;

namespace {

const ClassCatalog catalog = ClassCatalog::coco80();
const PinholeCamera<> camera{500.0, 500.0, 319.5, 239.5, 640, 480};

RangedDetection seen(const char* name, double u, double z) {
  return {box_around({u, 240.0}, 40.0, 40.0), catalog.at(name), 0.8, z};
}

}  // namespace

TEST_CASE("people make no nodes but hide what is behind them", "[graph]") {
  const auto sighting = sight_keyframe(
      7.0, {seen("cup", 100.0, 1.0), seen("person", 300.0, 2.0), seen("tv", 500.0, 0.0)}, camera,
      catalog);
  CHECK(sighting.stamp == 7.0);
  REQUIRE(sighting.nodes.size() == 1);
  CHECK(sighting.nodes[0].label == catalog.at("cup"));
  CHECK(sighting.view.occluders.size() == 3);
  CHECK_FALSE(sighting.gravity);
  CHECK_FALSE(sighting.view.should_show(camera.back_project({300.0, 240.0}, 3.0), 0.0, 8.0));
  CHECK(sighting.view.should_show(camera.back_project({400.0, 240.0}, 3.0), 0.0, 8.0));
}

TEST_CASE("a box of half the image, an unsure one and a broken one hide nothing", "[graph]") {
  RangedDetection room = seen("tv", 320.0, 1.0), unsure = seen("tv", 320.0, 1.0), broken = unsure;
  room.box = {0.0, 0.0, 639.0, 400.0};
  unsure.confidence = 0.1;
  broken.box.x1 = std::numeric_limits<double>::quiet_NaN();
  const auto sighting = sight_keyframe(0.0, {room, unsure, broken}, camera, catalog);
  CHECK(sighting.nodes.empty());
  CHECK(sighting.view.occluders.empty());
}

TEST_CASE("of ten thousand boxes the surest are used", "[graph]") {
  std::vector<RangedDetection> detections;
  for (int i = 0; i < 10000; ++i) {
    RangedDetection box = seen("cup", 20.0 + i % 600, 1.0 + i % 7);
    box.confidence = i == 9999 ? 0.9 : i % 2 == 0 ? 0.5 : std::numeric_limits<double>::quiet_NaN();
    detections.push_back(box);
  }
  SightingOptions options;
  options.max_detections = 20;
  const auto sighting = sight_keyframe(0.0, detections, camera, catalog, options);
  CHECK(sighting.view.occluders.size() == 20);
  CHECK(sighting.nodes.size() == 20);
  CHECK(sighting.nodes.front().confidence == 0.9);
  detections.assign(21, seen("cup", 100.0, 1.0));
  CHECK(sight_keyframe(0.0, detections, camera, catalog, options).view.occluders.size() == 20);
}

TEST_CASE("an unknown class is told by the caller's index, though the box be left out",
          "[graph][regression]") {
  std::vector<RangedDetection> detections(30, seen("cup", 100.0, 1.0));
  detections[7].label = ClassId{999};
  detections[7].confidence = 0.1;  // not among the surest
  SightingOptions options;
  for (const std::size_t most : {30U, 20U}) {
    options.max_detections = most;
    std::optional<std::size_t> index;
    try {
      sight_keyframe(0.0, detections, camera, catalog, options);
    } catch (const UnknownClass& unknown) {
      index = unknown.index();
    }
    CHECK(index == 7U);
  }
}

TEST_CASE("a depth that is no number is unknown, and the graph can be saved", "[graph][regression]") {
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(),
                           std::numeric_limits<double>::infinity(), -1.0}) {
    auto sighting = sight_keyframe(0.0, {seen("person", 300.0, bad)}, camera, catalog);
    REQUIRE(sighting.view.occluders.size() == 1);
    CHECK(sighting.view.occluders[0].z == 0.0);
    CHECK_NOTHROW(TopologyGraph<>(sighting.nodes, {}, {sighting.view}));
  }
}

namespace {

/// A front end's own detection, which cannot be made from nothing.
struct OwnBox {
  BoundingBox rectangle;
  const char* name;
  float metres;

  OwnBox(const BoundingBox& rectangle, const char* name, float metres)
      : rectangle(rectangle), name(name), metres(metres) {}
};

}  // namespace

template <>
struct topobag::detection_traits<OwnBox> {
  static BoundingBox box(const OwnBox& b) { return b.rectangle; }
  static ClassId label(const OwnBox& b) { return catalog.at(b.name); }
  static double confidence(const OwnBox& b) { return 0.5 + 0.1 * b.rectangle.x1 / 640.0; }
  static std::optional<double> depth(const OwnBox& b) { return static_cast<double>(b.metres); }
};

TEST_CASE("a front end's own detections are sighted as they are", "[graph]") {
  const std::vector<OwnBox> boxes{{box_around({100.0, 240.0}, 40.0, 40.0), "cup", 1.0F},
                                  {box_around({300.0, 240.0}, 40.0, 40.0), "person", 2.0F},
                                  {box_around({500.0, 240.0}, 40.0, 40.0), "tv", 3.0F}};
  const auto sighting = sight_keyframe(1.0, boxes, camera, catalog);
  REQUIRE(sighting.nodes.size() == 2);
  CHECK(sighting.nodes[1].label == catalog.at("tv"));
  CHECK(sighting.nodes[1].z == 3.0);
  REQUIRE(sighting.view.occluders.size() == 3);
  CHECK(sighting.view.occluders[1].z == 2.0);
  SightingOptions options;
  options.max_detections = 1;
  CHECK(sight_keyframe(1.0, boxes, camera, catalog, options).nodes.at(0).label == catalog.at("tv"));
}

TEST_CASE("with the depth image a sighting knows its objects' depth and how far it sees",
          "[graph]") {
  const auto depth = [](const Eigen::Vector2d& pixel) {
    return std::optional<double>(pixel.x() < 200.0 ? 1.0 : 4.0);
  };
  const std::vector<Detection> boxes{{box_around({100.0, 240.0}, 40.0, 40.0), catalog.at("cup")}};
  const auto sighting = sight_keyframe(1.0, boxes, depth, camera, catalog);
  REQUIRE(sighting.nodes.size() == 1);
  CHECK(sighting.nodes[0].z == Approx(1.0));
  REQUIRE(sighting.view.depth);
  CHECK((*sighting.view.depth)({400.0, 240.0}) == 4.0);
  PinholeCamera<> unsized = camera;
  unsized.width = unsized.height = 0;
  CHECK_FALSE(sight_keyframe(1.0, boxes, depth, unsized, catalog).view.depth);
}
