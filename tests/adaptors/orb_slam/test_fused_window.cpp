// SPDX-License-Identifier: MIT
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <random>
#include <set>
#include <vector>

#include <topobag/adaptors/orb_slam/key_frame_bag.hpp>

#include "adaptors/atlas_host.hpp"
#include "catch.hpp"

using namespace topobag;

namespace {

/// Key frames half a second apart, each fused with those of 1.2 s before it.
struct MovingMap {
  explicit MovingMap(unsigned seed) : room(seed, 9, 4), random(seed), bag(fusing(), {}) {
    for (unsigned long id = 0; id < 12; ++id) {
      const Eigen::Isometry3d T = random_camera(random);
      const double stamp = 0.5 * static_cast<double>(id);
      key_frames.push_back(std::make_unique<small_host::KeyFrame>(id, stamp, T));
      bag.observe(0, id, small_host::sighting(room, stamp, T));
      bag.add(key_frames.back().get());
    }
  }
  static LocalGraphOptions fusing() {
    LocalGraphOptions options;
    options.window = 1.2;
    return options;
  }
  void move(std::size_t i, const Eigen::Isometry3d& by) {
    key_frames[i]->SetPoseInverse(host_pose(key_frames[i]->GetPoseInverse()) * by);
  }

  SyntheticRoom room;
  std::mt19937 random;
  std::vector<std::unique_ptr<small_host::KeyFrame>> key_frames;
  KeyFrameBag<small_host::KeyFrame> bag;
};

Eigen::Isometry3d shift(double metres) {
  return Eigen::Isometry3d(Eigen::Translation3d(metres, 0.0, 0.0));
}

}  // namespace

TEST_CASE("just those graphs are made anew whose key frames moved against each other",
          "[adaptors]") {
  for (unsigned seed = 0; seed < 20; ++seed) {
    MovingMap map(seed);
    CHECK(map.bag.refresh_changed() == 0);
    std::set<std::size_t> moved;
    for (std::size_t i = 0; i < map.key_frames.size(); ++i) {
      if (map.random() % 5 == 0) moved.insert(i);
    }
    for (const std::size_t i : moved) map.move(i, shift(0.1 * static_cast<double>(1 + i)));
    std::size_t expected = 0;  // a window is a key frame and the two before it
    for (std::size_t i = 0; i < map.key_frames.size(); ++i) {
      const std::size_t begin = i < 2 ? 0 : i - 2;
      const bool alone = i == begin;
      bool one_moved = false;
      for (std::size_t j = begin; j <= i; ++j) one_moved = one_moved || moved.count(j) != 0;
      expected += one_moved && !alone ? 1U : 0U;
    }
    CHECK(map.bag.refresh_changed() == expected);
    CHECK(map.bag.refresh_changed() == 0);
  }
}

TEST_CASE("a world that moves as a whole, or a hair's breadth, leaves the graphs alone",
          "[adaptors]") {
  MovingMap map(3);
  const Eigen::Isometry3d world = random_camera(map.random) * shift(20.0);
  for (const auto& key_frame : map.key_frames) {
    key_frame->SetPoseInverse(world * host_pose(key_frame->GetPoseInverse()));
  }
  CHECK(map.bag.refresh_changed() == 0);
  map.move(4, shift(0.005));
  map.move(6, Eigen::Isometry3d(Eigen::AngleAxisd(0.003, Eigen::Vector3d::UnitY())));
  CHECK(map.bag.refresh_changed() == 0);
  map.move(6, Eigen::Isometry3d(Eigen::AngleAxisd(0.05, Eigen::Vector3d::UnitY())));
  CHECK(map.bag.refresh_changed() == 3);
}

TEST_CASE("a change of scale is noticed", "[adaptors]") {
  MovingMap map(5);
  for (const auto& key_frame : map.key_frames) {
    Eigen::Isometry3d T = host_pose(key_frame->GetPoseInverse());
    T.translation() *= 1.6;
    key_frame->SetPoseInverse(T);
  }
  CHECK(map.bag.refresh_changed() >= 10);  // all but those that happen to stand together
}

TEST_CASE("a culled neighbour, and one of another map, change a graph", "[adaptors]") {
  const SyntheticRoom room(7, 9, 4);
  std::mt19937 random(4);
  atlas_host::Map here, elsewhere;
  std::vector<std::unique_ptr<atlas_host::KeyFrame>> key_frames;
  KeyFrameBag<atlas_host::KeyFrame> bag({}, {});
  for (unsigned long id = 0; id < 3; ++id) {
    const Eigen::Isometry3d T = random_camera(random);
    const double stamp = 0.5 * static_cast<double>(id);
    key_frames.push_back(std::make_unique<atlas_host::KeyFrame>(
        atlas_host::KeyFrame{id, stamp, T, id == 0 ? &elsewhere : &here}));
    bag.observe(0, id, small_host::sighting(room, stamp, T));
    bag.add(key_frames.back().get());
  }
  CHECK(bag.refresh_changed() == 0);
  key_frames[0]->map = &here;  // merged
  CHECK(bag.refresh_changed() == 2);
  key_frames[1]->bad = true;
  CHECK(bag.refresh_changed() == 1);
  CHECK(bag.refresh_changed() == 0);
}

TEST_CASE("what the host says of gravity changes a graph", "[adaptors][gravity]") {
  const SyntheticRoom room(7, 9, 4);
  small_host::KeyFrame key_frame(1, 0.0, Eigen::Isometry3d::Identity());
  std::optional<Gravity<>> said;
  KeyFrameBag<small_host::KeyFrame> bag({}, {}, [&](small_host::KeyFrame&) { return said; });
  bag.observe(0, 1, small_host::sighting(room, 0.0, Eigen::Isometry3d::Identity()));
  bag.add(&key_frame);
  CHECK(bag.refresh_changed() == 0);
  said = Gravity<>{};
  CHECK(bag.refresh_changed() == 1);
  said->down = Eigen::Vector3d(0.001, 1.0, 0.0).normalized();
  CHECK(bag.refresh_changed() == 0);
  said->down = Eigen::Vector3d(0.1, 1.0, 0.0).normalized();
  CHECK(bag.refresh_changed() == 1);
}

TEST_CASE("a pose that cannot be read is tried again", "[adaptors]") {
  MovingMap map(6);
  const Eigen::Isometry3d before = host_pose(map.key_frames[5]->GetPoseInverse());
  Eigen::Isometry3d nowhere = before;
  nowhere.translation().x() = std::numeric_limits<double>::quiet_NaN();
  map.key_frames[5]->SetPoseInverse(nowhere);
  CHECK_THROWS_AS(map.bag.refresh_changed(), InvalidValue);
  CHECK(map.bag.size() == 12);
  map.key_frames[5]->SetPoseInverse(before);
  CHECK(map.bag.refresh_changed() == 0);  // the graphs stayed as they were
}
