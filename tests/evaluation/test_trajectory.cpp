// SPDX-License-Identifier: MIT
#include <topobag/evaluation/pose_error.hpp>
#include <topobag/evaluation/trajectory.hpp>

#include "catch.hpp"
#include "evaluation/random_poses.hpp"

using namespace topobag;
using topobag_tests::planar_pose;

TEST_CASE("a pose between two others lies on the straight line and the shorter arc",
          "[evaluation]") {
  const Trajectory trajectory{{1.0, planar_pose(0, 0, 170)}, {2.0, planar_pose(4, 8, -170)}};
  const auto pose = pose_at(trajectory, 1.25, 1.0);
  REQUIRE(pose);
  CHECK(pose_error(planar_pose(1, 2, 175), *pose).translation_m < 1e-12);
  CHECK(pose_error(planar_pose(1, 2, 175), *pose).rotation_deg < 1e-9);
}

TEST_CASE("interpolation ends at both poses and turns evenly", "[evaluation]") {
  std::mt19937 random(2);
  for (int i = 0; i < 500; ++i) {
    const Eigen::Isometry3d a = topobag_tests::random_pose(random);
    const Eigen::Isometry3d b = topobag_tests::random_pose(random);
    CHECK(pose_error(a, interpolate(a, b, 0.0)).rotation_deg < 1e-6);
    CHECK(pose_error(b, interpolate(a, b, 1.0)).rotation_deg < 1e-6);
    const double whole = pose_error(a, b).rotation_deg;
    const Eigen::Isometry3d third = interpolate(a, b, 1.0 / 3.0);
    CHECK(pose_error(a, third).rotation_deg == Approx(whole / 3.0).margin(1e-6));
    CHECK(pose_error(third, b).rotation_deg == Approx(whole * 2.0 / 3.0).margin(1e-6));
    CHECK(third.translation().isApprox((2.0 * a.translation() + b.translation()) / 3.0));
  }
}

TEST_CASE("there is no pose outside the trajectory or in a gap", "[evaluation]") {
  const Trajectory trajectory{
      {1.0, planar_pose(1, 0, 0)}, {1.4, planar_pose(2, 0, 0)}, {2.4, planar_pose(3, 0, 0)}};
  CHECK_FALSE(pose_at(trajectory, 0.9, 0.5));
  CHECK_FALSE(pose_at(trajectory, 2.5, 0.5));
  CHECK(pose_at(trajectory, 1.2, 0.5));
  CHECK_FALSE(pose_at(trajectory, 1.8, 0.5));  // 0.6 s before the next
  CHECK_FALSE(pose_at(trajectory, 1.9, 0.5));  // 0.5 s from both: not less
  CHECK(pose_at(trajectory, 1.8, 0.61));
  CHECK(pose_at(trajectory, 2.4, 0.5)->translation().x() == 3.0);
  CHECK_FALSE(pose_at({}, 1.0, 0.5));
}

TEST_CASE("the benchmark's rule is linear for near rotations and mirrored for far ones",
          "[evaluation]") {
  const auto turn = [](double to_deg, double alpha) {
    const Eigen::Isometry3d pose = interpolate(planar_pose(0, 0, 0), planar_pose(1, 0, to_deg),
                                               alpha, RotationInterpolation::openloris);
    CHECK(pose.translation().x() == Approx(alpha));
    return pose_error(planar_pose(0, 0, 0), pose).rotation_deg;
  };
  CHECK(turn(0.2, 0.25) == Approx(0.05).epsilon(1e-5));
  // Half turned by 10°: w² for w1·w2 makes the inner product cos² 5°, not cos 5°.
  const double inner = std::pow(std::cos(5.0 / degrees_per_radian), 2);
  const double angle = std::acos(inner);
  const double weight_a = std::sin(0.25 * angle);
  const double weight_b = std::sin(0.75 * angle);
  const double half = std::atan2(weight_b * std::sin(5.0 / degrees_per_radian),
                                 weight_a + weight_b * std::cos(5.0 / degrees_per_radian));
  CHECK(turn(10.0, 0.25) == Approx(2.0 * half * degrees_per_radian));
  CHECK(turn(10.0, 0.25) > 5.0);
}

TEST_CASE("another frame on the same body moves along", "[evaluation]") {
  const Trajectory camera = in_frame({{0.0, planar_pose(1, 2, 90)}}, planar_pose(0.5, 0, 0));
  CHECK(camera[0].T_world_body.translation().isApprox(Eigen::Vector3d(1.0, 2.5, 0.0)));
}
