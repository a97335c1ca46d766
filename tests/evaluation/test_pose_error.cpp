// SPDX-License-Identifier: MIT
#include <limits>
#include <random>

#include <topobag/evaluation/pose_error.hpp>

#include "catch.hpp"

using namespace topobag;

namespace {

Eigen::Isometry3d pose(double x, double y, double z, double angle_deg,
                       const Eigen::Vector3d& axis) {
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.translation() << x, y, z;
  T.linear() = Eigen::AngleAxisd(angle_deg / degrees_per_radian, axis.normalized()).matrix();
  return T;
}

}  // namespace

TEST_CASE("the error of a pose is what was added to it", "[evaluation]") {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> coordinate(-5.0, 5.0);
  std::uniform_real_distribution<double> angle(0.0, 180.0);
  const auto draw = [&] {
    const Eigen::Vector3d axis(coordinate(random), coordinate(random), coordinate(random));
    return pose(coordinate(random), coordinate(random), coordinate(random), angle(random), axis);
  };
  for (int i = 0; i < 1000; ++i) {
    const Eigen::Isometry3d T_true = draw();
    const double angle_deg = angle(random);
    const Eigen::Isometry3d added = pose(3.0, 0.0, 4.0, angle_deg, draw().translation());
    const PoseError error = pose_error(T_true, T_true * added);
    CHECK(error.translation_m == Approx(5.0));
    CHECK(error.rotation_deg == Approx(angle_deg).margin(1e-9));

    // It is blind to the choice of the world frame.
    const Eigen::Isometry3d other_world = draw();
    const PoseError moved = pose_error(other_world * T_true, other_world * T_true * added);
    CHECK(moved.translation_m == Approx(error.translation_m));
    CHECK(moved.rotation_deg == Approx(error.rotation_deg).margin(1e-9));
  }
}

TEST_CASE("small and opposite angles keep their digits", "[evaluation]") {
  const Eigen::Vector3d axis(1.0, 2.0, 3.0);
  CHECK(rotation_angle_deg(Eigen::Matrix3d::Identity()) == 0.0);
  CHECK(rotation_angle_deg(pose(0, 0, 0, 1e-9, axis).linear()) == Approx(1e-9).epsilon(1e-5));
  CHECK(rotation_angle_deg(pose(0, 0, 0, 180.0, axis).linear()) == Approx(180.0).epsilon(1e-14));
  CHECK(rotation_angle_deg(pose(0, 0, 0, 270.0, axis).linear()) == Approx(90.0));
}

TEST_CASE("the verdict's limits belong to the better side", "[evaluation]") {
  CHECK(judge({0.0, 0.0}) == PoseVerdict::correct);
  CHECK(judge({0.3, 15.0}) == PoseVerdict::correct);
  CHECK(judge({0.31, 15.0}) == PoseVerdict::imprecise);
  CHECK(judge({0.3, 15.1}) == PoseVerdict::imprecise);
  CHECK(judge({1.0, 45.0}) == PoseVerdict::imprecise);
  CHECK(judge({1.01, 0.0}) == PoseVerdict::wrong);
  CHECK(judge({0.0, 45.1}) == PoseVerdict::wrong);
}

TEST_CASE("the four limits are the caller's, and an unknown error is wrong", "[evaluation]") {
  const PoseLimits limits{2.0, 30.0, 3.0, 60.0};
  CHECK(judge({2.0, 30.0}, limits) == PoseVerdict::correct);
  CHECK(judge({2.5, 10.0}, limits) == PoseVerdict::imprecise);
  CHECK(judge({0.1, 61.0}, limits) == PoseVerdict::wrong);
  CHECK(judge({std::numeric_limits<double>::quiet_NaN(), 0.0}) == PoseVerdict::wrong);
}
