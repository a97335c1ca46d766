// SPDX-License-Identifier: MIT
#include <limits>
#include <random>

#include <topobag/sensing/pinhole_camera.hpp>

#include "catch.hpp"

using namespace topobag;

namespace {

const PinholeCamera<> kinect{500.0, 400.0, 320.0, 240.0, 640, 480};

}  // namespace

TEST_CASE("eq. 5 on hand-computed points", "[sensing][paper]") {
  CHECK(kinect.back_project({320.0, 240.0}, 2.0) == Eigen::Vector3d(0.0, 0.0, 2.0));
  CHECK(kinect.back_project({420.0, 140.0}, 2.0) == Eigen::Vector3d(0.4, -0.5, 2.0));
  // Raw depth 10000 at F = 5000 is 2 m.
  CHECK(kinect.back_project({420.0, 140.0}, 10000.0, 5000.0) == Eigen::Vector3d(0.4, -0.5, 2.0));
}

TEST_CASE("projecting undoes back-projecting", "[sensing]") {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> u(-200.0, 900.0);
  std::uniform_real_distribution<double> z(0.05, 20.0);
  for (int i = 0; i < 1000; ++i) {
    const Eigen::Vector2d pixel(u(random), u(random));
    const auto projected = kinect.project(kinect.back_project(pixel, z(random)));
    REQUIRE(projected);
    CHECK((*projected - pixel).norm() < 1e-9);
  }
}

TEST_CASE("nothing at or behind the camera has a pixel", "[sensing]") {
  CHECK(kinect.project({0.0, 0.0, 1e-3}));
  CHECK_FALSE(kinect.project({0.0, 0.0, 0.0}));
  CHECK_FALSE(kinect.project({0.1, 0.1, -1.0}));
  CHECK_FALSE(kinect.project({0.0, 0.0, std::numeric_limits<double>::quiet_NaN()}));
}

TEST_CASE("the image reaches from pixel 0 to pixel width - 1", "[sensing]") {
  CHECK(kinect.in_image({0.0, 0.0}));
  CHECK(kinect.in_image({639.0, 479.0}));
  CHECK_FALSE(kinect.in_image({639.1, 0.0}));
  CHECK_FALSE(kinect.in_image({-0.1, 0.0}));
  CHECK(kinect.in_image({10.0, 469.0}, 10.0));
  CHECK_FALSE(kinect.in_image({9.9, 240.0}, 10.0));
  CHECK_FALSE(kinect.in_image({std::numeric_limits<double>::quiet_NaN(), 1.0}));
}

TEST_CASE("a camera that cannot be is refused", "[sensing]") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  CHECK_NOTHROW(kinect.validate());
  CHECK_NOTHROW((PinholeCamera<>{500.0, 500.0, -10.0, 1000.0}.validate()));
  CHECK_THROWS_AS(PinholeCamera<>{}.validate(), InvalidValue);
  CHECK_THROWS_AS((PinholeCamera<>{-500.0, 500.0, 0.0, 0.0}.validate()), InvalidValue);
  CHECK_THROWS_AS((PinholeCamera<>{500.0, nan, 0.0, 0.0}.validate()), InvalidValue);
  CHECK_THROWS_AS((PinholeCamera<>{500.0, 500.0, inf, 0.0}.validate()), InvalidValue);
  CHECK_THROWS_AS((PinholeCamera<>{500.0, 500.0, 0.0, nan}.validate()), InvalidValue);
  CHECK_THROWS_AS((PinholeCamera<>{500.0, 500.0, 0.0, 0.0, -1, 480}.validate()), InvalidValue);
}

TEST_CASE("a camera changes its scalar and nothing else", "[sensing]") {
  const PinholeCamera<float> single = kinect.cast<float>();
  CHECK(single.fx == 500.0F);
  CHECK(single.fy == 400.0F);
  CHECK(single.cx == 320.0F);
  CHECK(single.cy == 240.0F);
  CHECK(single.width == 640);
  CHECK(single.height == 480);
}
