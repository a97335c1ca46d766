// SPDX-License-Identifier: MIT
#include <topobag/evaluation/frustum_overlap.hpp>

#include "catch.hpp"
#include "evaluation/random_poses.hpp"

using namespace topobag;

namespace {

const DepthFrustum kinect{{517.3, 516.5, 318.6, 255.3, 640, 480}, 0.5, 4.0};

Eigen::Isometry3d step(double x, double z) {
  return Eigen::Isometry3d(Eigen::Translation3d(x, 0.0, z));
}

}  // namespace

TEST_CASE("a camera sees all of what it sees, and none of what is behind", "[evaluation]") {
  CHECK(frustum_overlap(kinect, Eigen::Isometry3d::Identity()) == 1.0);
  Eigen::Isometry3d back = Eigen::Isometry3d::Identity();
  back.linear() = Eigen::AngleAxisd(3.14159265358979, Eigen::Vector3d::UnitY()).matrix();
  CHECK(frustum_overlap(kinect, back) == 0.0);
  CHECK(frustum_overlap(kinect, step(100.0, 0.0)) == 0.0);
}

TEST_CASE("two cameras face to face share what lies between", "[evaluation]") {
  Eigen::Isometry3d facing = step(0.0, 4.5);
  facing.linear() = Eigen::AngleAxisd(3.14159265358979, Eigen::Vector3d::UnitY()).matrix();
  CHECK(frustum_overlap(kinect, facing) > 0.3);
}

TEST_CASE("the overlap falls with the distance", "[evaluation]") {
  double last = 1.0;
  for (int i = 1; i <= 12; ++i) {
    const double overlap = frustum_overlap(kinect, step(0.5 * i, 0.0));
    CHECK(overlap <= last);
    last = overlap;
  }
  CHECK(last == 0.0);
}

TEST_CASE("the overlap is symmetric and in [0, 1]", "[evaluation]") {
  std::mt19937 random(9);
  for (int i = 0; i < 300; ++i) {
    const Eigen::Isometry3d T = topobag_tests::random_pose(random, 3.0);
    const double overlap = frustum_overlap(kinect, T);
    CHECK(overlap >= 0.0);
    CHECK(overlap <= 1.0);
    CHECK(frustum_overlap(kinect, T.inverse(Eigen::Isometry)) == Approx(overlap).margin(1.0 / 512));
  }
}

TEST_CASE("a frustum needs an image and depths", "[evaluation]") {
  CHECK_NOTHROW(kinect.validate());
  DepthFrustum frustum = kinect;
  frustum.camera.width = 0;
  CHECK_THROWS_AS(frustum.validate(), InvalidValue);
  frustum = kinect;
  frustum.near_m = 0.0;
  CHECK_THROWS_AS(frustum.validate(), InvalidValue);
  frustum.near_m = 4.0;
  CHECK_THROWS_AS(frustum.validate(), InvalidValue);
}
