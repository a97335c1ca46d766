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

TEST_CASE("a rig's cameras are added at one stamp", "[docs]") {
  const Eigen::Isometry3d T_left_right(Eigen::Translation3d(0.3, 0.0, 0.0));
  const Eigen::Isometry3d T_before_now(Eigen::Translation3d(0.0, 0.0, 0.1));
  KeyframeSighting seen_left, seen_right;
  seen_left.nodes.resize(1);
  seen_left.nodes[0].position = Eigen::Vector3d(0.0, 0.0, 2.0);
  LocalGraph<> local;
  for (seen_left.stamp = 0.0; seen_left.stamp < 2.0; ++seen_left.stamp) {
    seen_right.stamp = seen_left.stamp;
    local.add(seen_left, T_left_right.inverse() * T_before_now);  // to the right camera of the stamp before
    local.add(seen_right, T_left_right);                          // to the left camera of this stamp
    seen_left.nodes[0].position->z() -= 0.1;
  }
  REQUIRE(local.graph().size() == 1);
  CHECK(local.graph().nodes()[0].position->isApprox(Eigen::Vector3d(-0.3, 0.0, 1.9), 1e-9));
}
