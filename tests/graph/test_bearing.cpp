// SPDX-License-Identifier: MIT
#include <cmath>
#include <random>
#include <vector>

#include <topobag/graph/bearing.hpp>

#include "catch.hpp"

using namespace topobag;

namespace {

const PinholeCamera<> bearing_camera{500.0, 520.0, 320.0, 240.0, 640, 480};

Detection seen_at(const char* name, double u, double v, double width, double height) {
  return {box_around({u, v}, width, height), *ClassCatalog::coco80().find(name), 0.8};
}

}  // namespace

TEST_CASE("a bearing points where the box's middle is, at any depth", "[bearing]") {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> u(100.0, 540.0), v(100.0, 380.0), depth(0.5, 8.0);
  for (int round = 0; round < 100; ++round) {
    const double x = u(random), y = v(random);
    const auto sighting = sight_bearings(std::vector<Detection>{seen_at("cup", x, y, 40.0, 52.0)},
                                         bearing_camera, ClassCatalog::coco80());
    REQUIRE(sighting.bearings.size() == 1);
    const Bearing& bearing = sighting.bearings[0];
    const double z = depth(random);
    CHECK((z / bearing.direction.z() * bearing.direction - bearing_camera.back_project({x, y}, z))
              .norm() < 1e-9);
    CHECK(bearing.direction.norm() == Approx(1.0));
    CHECK(bearing.extent.x() * z == Approx(40.0 * z / 500.0));
    CHECK(bearing.extent.y() * z == Approx(52.0 * z / 520.0));
    CHECK(bearing.deviation > BearingNoise{}.floor);
  }
}

TEST_CASE("of a box that the border cuts the extent is unknown and the middle uncertain",
          "[bearing]") {
  const auto sighting =
      sight_bearings(std::vector<Detection>{seen_at("cup", 20.0, 240.0, 60.0, 60.0),
                                            seen_at("cup", 320.0, 240.0, 60.0, 60.0)},
                     bearing_camera, ClassCatalog::coco80());
  REQUIRE(sighting.bearings.size() == 2);
  CHECK(sighting.bearings[0].extent.isZero());
  CHECK_FALSE(sighting.bearings[1].extent.isZero());
  CHECK(sighting.bearings[0].deviation > 2.0 * sighting.bearings[1].deviation);
}

TEST_CASE("detections are left out as those with depth are, and hide what is behind", "[bearing]") {
  const std::vector<Detection> detections{
      seen_at("person", 100.0, 240.0, 60.0, 200.0), seen_at("cup", 320.0, 240.0, 60.0, 60.0),
      seen_at("bowl", 322.0, 241.0, 58.0, 60.0), seen_at("tv", 320.0, 240.0, 600.0, 400.0)};
  const auto sighting = sight_bearings(detections, bearing_camera, ClassCatalog::coco80());
  REQUIRE(sighting.sources == std::vector<std::size_t>{1});
  CHECK(sighting.dropped.dynamic == 1);
  CHECK(sighting.dropped.duplicate == 1);  // the bowl is the cup
  CHECK(sighting.dropped.too_large == 1);
  CHECK(sighting.dropped.no_depth == 0);
  REQUIRE(sighting.view.occluders.size() == 3);  // the person, too, but not the room
  CHECK(sighting.view.occluders[0].z == 0.0);
}

TEST_CASE("a class that the catalog does not know is no bearing", "[bearing]") {
  Detection detection = seen_at("cup", 320.0, 240.0, 60.0, 60.0);
  detection.label = ClassId{80};
  CHECK_THROWS_AS(
      sight_bearings(std::vector<Detection>{detection}, bearing_camera, ClassCatalog::coco80()),
      Error);
}
