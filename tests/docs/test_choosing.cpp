// SPDX-License-Identifier: MIT
// What examples/docs/choosing.md shows.
#include <topobag/graph/local_graph.hpp>
#include <topobag/recognition/relocalizer.hpp>
#include <topobag/sensing/lift_detections.hpp>
#include <topobag/sensing/sensor_profile.hpp>

#include "catch.hpp"

using namespace topobag;

TEST_CASE("a sensor's ranges reach every step", "[docs]") {
  const ClassCatalog catalog = ClassCatalog::coco80();
  const SensorProfile sensor = SensorProfile::lidar();  // or stereo_robot(), warehouse(), one of your own
  const LiftOptions lifting = lift_options(sensor);
  LocalGraph<> window(local_graph_options(sensor));
  Relocalizer<> relocalizer(recognition_options(catalog, sensor));
  CHECK(lifting.max_depth == sensor.max_depth);
  CHECK(window.graph([](const auto&) { return EdgeList{}; }).empty());
  CHECK(relocalizer.options().place.radius == sensor.place_radius);
}
