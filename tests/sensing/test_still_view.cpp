// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include <topobag/error.hpp>
#include <topobag/sensing/still_view.hpp>

#include "catch.hpp"

using namespace topobag;

namespace {

Eigen::Isometry3d pose_at(double x, double yaw = 0.0) {
  return Eigen::Translation3d(x, 0.0, 0.0) * Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitY());
}

}  // namespace

TEST_CASE("a view that hardly changes is not looked at again, until it is old", "[sensing]") {
  StillView view;
  CHECK(view.should_look(10.0, pose_at(0.0)));
  CHECK_FALSE(view.should_look(10.4, pose_at(0.05)));
  CHECK_FALSE(view.should_look(10.8, pose_at(0.09)));
  CHECK(view.should_look(11.2, pose_at(0.11)));
  CHECK_FALSE(view.should_look(11.6, pose_at(0.11, 0.09)));
  CHECK(view.should_look(12.0, pose_at(0.11, 0.11)));
  CHECK_FALSE(view.should_look(17.0, pose_at(0.11, 0.11)));
  CHECK(view.should_look(17.1, pose_at(0.11, 0.11)));
}

TEST_CASE("a failed look and a clock that goes back are no reason not to look", "[sensing]") {
  StillView view;
  CHECK(view.should_look(10.0, pose_at(0.0)));
  view.forget();
  CHECK(view.should_look(10.1, pose_at(0.0)));
  CHECK(view.should_look(9.0, pose_at(0.0)));
}

TEST_CASE("whatever is not looked at was seen from near by not long ago", "[sensing]") {
  std::mt19937 random(31);
  std::normal_distribution<double> step(0.0, 0.04);
  StillView view({0.15, 0.5, 2.0});
  double stamp = 0.0, looked_at = 0.0;
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity(), looked_from = pose;
  int looks = 0;
  for (int i = 0; i < 2000; ++i) {
    stamp += 0.1;
    pose = pose * pose_at(step(random), step(random));
    const Eigen::Isometry3d between = looked_from.inverse() * pose;
    const double motion =
        between.translation().norm() + 0.5 * Eigen::AngleAxisd(between.linear()).angle();
    const bool near = i > 0 && motion <= 0.15 && stamp - looked_at <= 2.0;
    REQUIRE(view.should_look(stamp, pose) == !near);
    if (near) continue;
    looked_from = pose;
    looked_at = stamp;
    ++looks;
  }
  CHECK((looks > 20 && looks < 1000));
}

TEST_CASE("what is no pose, and no number, is refused", "[sensing]") {
  StillView view;
  Eigen::Isometry3d scaled = pose_at(0.0);
  scaled.linear() *= 2.0;
  CHECK_THROWS_AS(view.should_look(0.0, scaled), InvalidValue);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const StillViewOptions& bad :
       std::vector<StillViewOptions>{{-1.0, 1.0, 1.0}, {1.0, nan, 1.0}, {1.0, 1.0, -1.0}}) {
    CHECK_THROWS_AS(StillView(bad), InvalidValue);
  }
}
