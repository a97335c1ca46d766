// SPDX-License-Identifier: MIT
#include <Eigen/Core>

#include <topobag/sensing/lift_options.hpp>

#include "catch.hpp"

using namespace topobag;

namespace {

Eigen::Matrix3d noise_of(const NodeNoise& noise) {
  return noise.covariance(Eigen::Vector3d(0.5, 0.2, 3.0), Eigen::Vector2d(0.4, 0.3), false);
}

}  // namespace

TEST_CASE("the default sensor is the hand-held one, and what lifting takes", "[sensing]") {
  const LiftOptions usual, lifted = lift_options(SensorProfile::hand_held_rgbd());
  CHECK(lifted.min_depth == usual.min_depth);
  CHECK(lifted.max_depth == usual.max_depth);
  CHECK(noise_of(lifted.noise) == noise_of(usual.noise));
}

TEST_CASE("a sensor says what is lifted by its range and its noise, and nothing else",
          "[sensing]") {
  const LiftOptions usual;
  for (const SensorProfile& sensor :
       {SensorProfile::stereo_robot(), SensorProfile::warehouse(), SensorProfile::lidar()}) {
    const LiftOptions lifted = lift_options(sensor);
    CHECK(lifted.min_depth == sensor.min_depth);
    CHECK(lifted.max_depth == sensor.max_depth);
    CHECK(noise_of(lifted.noise) == noise_of(sensor.noise));
    CHECK(lifted.max_depth > usual.max_depth);
    CHECK(lifted.min_confidence == usual.min_confidence);
    CHECK(lifted.max_image_share == usual.max_image_share);
    for (const Dynamics level : {Dynamics::low, Dynamics::medium, Dynamics::high}) {
      CHECK(lifted.keep.contains(level) == usual.keep.contains(level));
    }
  }
}
