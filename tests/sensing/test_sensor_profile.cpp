// SPDX-License-Identifier: MIT
#include <topobag/sensing/lift_detections.hpp>
#include <topobag/sensing/sensor_profile.hpp>

#include "catch.hpp"

using namespace topobag;

TEST_CASE("every profile's ranges, gates and radii are in order", "[sensing]") {
  for (const SensorProfile& sensor :
       {SensorProfile::hand_held_rgbd(), SensorProfile::stereo_robot(), SensorProfile::warehouse(),
        SensorProfile::lidar()}) {
    CHECK(0.0 < sensor.min_depth);
    CHECK(sensor.min_depth < sensor.sure_range);
    CHECK(sensor.sure_range <= sensor.detection_range);
    CHECK(sensor.detection_range <= sensor.max_depth);
    CHECK(0.0 < sensor.least_tolerance);
    CHECK(sensor.least_tolerance < sensor.gate);
    CHECK(sensor.pose_resolution <= sensor.place_resolution);
    CHECK(sensor.place_resolution < sensor.place_radius);
  }
}

TEST_CASE("what is measured beyond a sensor's range is not lifted", "[sensing]") {
  const ClassCatalog catalog = ClassCatalog::coco80();
  const PinholeCamera<> camera{500.0, 500.0, 320.0, 240.0, 640, 480};
  Detection plant;
  plant.label = *catalog.find("potted plant");
  plant.box = {300.0, 220.0, 340.0, 260.0};
  plant.confidence = 0.9;
  const auto lifted_at = [&](double metres, const SensorProfile& sensor) {
    const auto depth = [&](const auto&) { return std::optional<double>(metres); };
    return lift_detections(std::vector<Detection>{plant}, depth, camera, catalog,
                           lift_options(sensor))
        .nodes.size();
  };
  CHECK(lifted_at(15.0, SensorProfile::hand_held_rgbd()) == 0);
  CHECK(lifted_at(15.0, SensorProfile::stereo_robot()) == 1);
  CHECK(lifted_at(50.0, SensorProfile::stereo_robot()) == 0);
  CHECK(lifted_at(50.0, SensorProfile::lidar()) == 1);
  CHECK(lifted_at(0.5, SensorProfile::hand_held_rgbd()) == 1);
  CHECK(lifted_at(0.5, SensorProfile::lidar()) == 0);
}
