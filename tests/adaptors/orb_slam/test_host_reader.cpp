// SPDX-License-Identifier: MIT
#include <chrono>
#include <memory>
#include <mutex>
#include <random>
#include <thread>
#include <utility>

#include <topobag/adaptors/orb_slam/key_frame_bag.hpp>

#include "adaptors/small_host.hpp"
#include "catch.hpp"

using namespace topobag;

namespace {

/// A lock that knows whether it is held.
struct WatchedMutex {
  bool held = false;

  bool try_lock() { return std::exchange(held, true) == false; }
  void lock() { held = true; }
  void unlock() { held = false; }
};

struct WatchedMap {
  WatchedMutex mMutexMapUpdate;

  bool IsBad() const { return false; }
};

/// Counts how often its pose is read, and how often under its map's lock.
struct WatchedKeyFrame {
  unsigned long mnId;
  double mTimeStamp;
  WatchedMap* map;
  int read = 0, read_under_lock = 0;

  bool isBad() const { return false; }
  WatchedMap* GetMap() const { return map; }
  Eigen::Isometry3f GetPoseInverse() {
    ++read;
    read_under_lock += map->mMutexMapUpdate.held ? 1 : 0;
    return Eigen::Isometry3f::Identity();
  }
};

}  // namespace

TEST_CASE("graphs are fused under the lock of their map, places are read without", "[adaptors]") {
  const SyntheticRoom room(7, 9, 4);
  const Eigen::Isometry3d origin = Eigen::Isometry3d::Identity();
  WatchedMap map;
  WatchedKeyFrame first{1, 0.0, &map}, second{2, 1.0, &map};
  KeyFrameBag<WatchedKeyFrame> bag({}, {});
  for (WatchedKeyFrame* key_frame : {&first, &second}) {
    bag.add(key_frame);
    bag.observe(0, key_frame->mnId, small_host::sighting(room, key_frame->mTimeStamp, origin));
  }
  bag.refresh();
  bag.graph_of(&second, std::chrono::milliseconds(0));
  CHECK(first.read == 5);  // two graphs, both anew, and that of the second once more
  CHECK(first.read_under_lock == first.read);
  CHECK(second.read_under_lock == second.read);
  CHECK_FALSE(map.mMutexMapUpdate.held);
  map.mMutexMapUpdate.lock();  // as tracking does
  const int before = first.read_under_lock;
  CHECK_FALSE(bag.places(room.seen_from(origin), {}).empty());
  CHECK(map.mMutexMapUpdate.held);
  CHECK(first.read_under_lock > before);
}

TEST_CASE("a graph never mixes poses of before and after a correction", "[adaptors]") {
  const SyntheticRoom room(7, 9, 4);
  std::mt19937 random(6);
  const Eigen::Isometry3d pose = random_camera(random), other = random_camera(random);
  small_host::KeyFrame first(1, 0.0, pose), second(2, 1.0, other);
  std::mutex map_mutex;
  KeyFrameBag<small_host::KeyFrame> bag({}, {});
  bag.hold_poses_with(map_mutex);
  bag.observe(0, 1, small_host::sighting(room, 0.0, pose));
  bag.observe(0, 2, small_host::sighting(room, 1.0, other));
  bag.add(&first);
  std::thread loop_closing;
  {
    const std::lock_guard<std::mutex> held(map_mutex);
    const Eigen::Isometry3d moved(Eigen::Translation3d(1.0, 0.0, 0.0));
    second.SetPoseInverse(moved * other);
    loop_closing = std::thread([&] { bag.add(&second); });
    for (int i = 0; i < 1000; ++i) std::this_thread::yield();
    CHECK(bag.size() == 1);
    first.SetPoseInverse(moved * pose);
  }
  loop_closing.join();
  CHECK(bag.size() == 2);
  const auto graph = bag.graph_of(&second, std::chrono::milliseconds(0));
  REQUIRE(graph);
  CHECK(graph->size() == room.seen_from(other).size());  // each object once
}

TEST_CASE("the host may erase a key frame under the lock that its graph waits for",
          "[adaptors][regression]") {
  const SyntheticRoom room(7, 9, 4);
  const Eigen::Isometry3d origin = Eigen::Isometry3d::Identity();
  std::mutex map_mutex;
  KeyFrameBag<small_host::KeyFrame> bag({}, {});
  bag.hold_poses_with(map_mutex);
  auto erased = std::make_unique<small_host::KeyFrame>(1, 0.0, origin);
  small_host::KeyFrame kept(2, 1.0, origin);
  for (const unsigned long id : {1UL, 2UL})
    bag.observe(0, id, small_host::sighting(room, 0.0, origin));
  std::unique_lock<std::mutex> held(map_mutex);
  std::thread first([&] { bag.add(erased.get()); }), second([&] { bag.add(&kept); });
  for (int i = 0; i < 1000; ++i) std::this_thread::yield();
  bag.erase(*erased);
  first.join();
  erased.reset();
  held.unlock();
  second.join();
  CHECK(bag.size() == 1);
}
