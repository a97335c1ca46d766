// SPDX-License-Identifier: MIT
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include <topobag/graph/keyframe_sighting.hpp>

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
