// SPDX-License-Identifier: MIT
#include <chrono>
#include <optional>
#include <random>

#include <topobag/adaptors/orb_slam.hpp>

#include "adaptors/atlas_host.hpp"
#include "catch.hpp"

using namespace topobag;

namespace {

struct InertialMap : atlas_host::Map {
  bool initialized = false;

  bool isImuInitialized() const { return initialized; }
};

struct InertialKeyFrame {
  unsigned long mnId;
  double mTimeStamp;
  Eigen::Isometry3d T_world_camera;
  InertialMap* map;

  bool isBad() const { return false; }
  InertialMap* GetMap() const { return map; }
  Eigen::Isometry3f GetPoseInverse() const {
    return Eigen::Isometry3f(T_world_camera.cast<float>());
  }
};

}  // namespace

TEST_CASE("down is against the z axis of a map whose IMU is initialised", "[adaptors][gravity]") {
  std::mt19937 random(3);
  InertialMap map;
  for (int i = 0; i < 10; ++i) {
    InertialKeyFrame key_frame{1, 0.0, random_camera(random), &map};
    map.initialized = false;
    CHECK_FALSE(inertial_gravity(key_frame));
    map.initialized = true;
    const auto gravity = inertial_gravity(key_frame);
    REQUIRE(gravity);
    const Eigen::Vector3d down = key_frame.T_world_camera.linear() * gravity->down;
    CHECK((down + Eigen::Vector3d::UnitZ()).norm() < 1e-6);
    CHECK(gravity->deviation == Gravity<>{}.deviation);
  }
}

TEST_CASE("hosts that know nothing of an IMU say nothing of gravity", "[adaptors][gravity]") {
  atlas_host::Map map;
  atlas_host::KeyFrame of_atlas{1, 0.0, Eigen::Isometry3d::Identity(), &map};
  small_host::KeyFrame of_one_map(1, 0.0, Eigen::Isometry3d::Identity());
  CHECK_FALSE(inertial_gravity(of_atlas));
  CHECK_FALSE(inertial_gravity(of_one_map));
}

TEST_CASE("graphs learn of gravity when the host's IMU is initialised", "[adaptors][gravity]") {
  const SyntheticRoom room(7, 9, 4);
  const Eigen::Isometry3d origin = Eigen::Isometry3d::Identity();
  InertialMap map;
  InertialKeyFrame key_frame{1, 0.0, origin, &map};
  KeyFrameBag<InertialKeyFrame> bag({}, {}, inertial_gravity<InertialKeyFrame>);
  bag.observe(0, 1, small_host::sighting(room, 0.0, origin));
  bag.add(&key_frame);
  CHECK_FALSE(bag.copy_of(&map).map().find(KeyframeId{1})->gravity());
  map.initialized = true;
  CHECK(bag.refresh_changed() == 1);
  CHECK(bag.copy_of(&map).map().find(KeyframeId{1})->gravity());
  CHECK(bag.refresh_changed() == 0);
}
