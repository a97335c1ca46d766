// SPDX-License-Identifier: MIT
#include <random>
#include <vector>

#include <topobag/adaptors/orb_slam/host_worlds.hpp>

#include "catch.hpp"
#include "recognition/synthetic_room.hpp"

using namespace topobag;

TEST_CASE("cameras of one map stay as they are to each other, those of two are far apart",
          "[adaptors]") {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> metres(-1e7, 1e7);  // maps in the frame of the Earth
  HostWorlds worlds;
  const std::vector<int> maps(100);
  std::vector<HostCamera> cameras;
  for (const int& map : maps) {
    for (int i = 0; i < 2; ++i) {
      Eigen::Isometry3d T = random_camera(random);
      T.pretranslate(Eigen::Vector3d(metres(random), metres(random), metres(random)));
      cameras.push_back({&map, T});
      const Eigen::Isometry3d in_world = worlds.T_world_camera(cameras.back());
      if (&map == &maps.front()) CHECK(in_world.matrix() == T.matrix());
    }
  }
  for (const HostCamera& a : cameras) {
    for (const HostCamera& b : cameras) {
      const Eigen::Isometry3d between =
          worlds.T_world_camera(a).inverse() * worlds.T_world_camera(b);
      const Eigen::Isometry3d expected = a.T_map_camera.inverse() * b.T_map_camera;
      if (a.map == b.map) {
        CHECK((between.matrix() - expected.matrix()).norm() < 1e-4);
      } else {
        CHECK(between.translation().norm() > 1e7);
      }
    }
  }
}

TEST_CASE("after all maps are forgotten, the next one is the first", "[adaptors]") {
  const int one = 1, other = 2;
  const Eigen::Isometry3d T(Eigen::Translation3d(1.0, 2.0, 3.0));
  HostWorlds worlds;
  worlds.T_world_camera({&one, T});
  CHECK(worlds.T_world_camera({&other, T}).translation().x() > 1e7);
  worlds.clear();
  CHECK(worlds.T_world_camera({&other, T}).matrix() == T.matrix());
}
