// SPDX-License-Identifier: MIT
#include <atomic>
#include <memory>
#include <mutex>
#include <random>
#include <set>
#include <thread>

#include <topobag/adaptors/orb_slam/key_frame_bag.hpp>

#include "adaptors/small_host.hpp"
#include "catch.hpp"

using namespace topobag;

namespace {

/// A key frame whose pose is read slowly: until it is let go.
struct SlowKeyFrame {
  unsigned long mnId = 1;
  double mTimeStamp = 0.0;
  std::atomic<bool>* being_read = nullptr;
  std::atomic<bool>* let_go = nullptr;

  bool isBad() const { return false; }
  small_host::Pose GetPoseInverse() const {
    if (being_read != nullptr) {
      *being_read = true;
      while (!*let_go) std::this_thread::yield();
    }
    return {};
  }
};

}  // namespace

TEST_CASE("erase and clear wait for whoever reads the key frame", "[adaptors]") {
  const bool by_clear = GENERATE(false, true);
  const SyntheticRoom room(7, 9, 4);
  const Eigen::Isometry3d origin = Eigen::Isometry3d::Identity();
  std::atomic<bool> being_read{false}, let_go{false}, forgotten{false};
  KeyFrameBag<SlowKeyFrame> bag({}, {});
  auto key_frame = std::make_unique<SlowKeyFrame>();
  bag.observe(0, 1, small_host::sighting(room, 0.0, origin));
  bag.add(*key_frame);
  REQUIRE(bag.size() == 1);
  key_frame->being_read = &being_read;
  key_frame->let_go = &let_go;

  std::thread query([&] { CHECK(!bag.places(room.seen_from(origin), {}, {}, nullptr).empty()); });
  while (!being_read) std::this_thread::yield();
  std::thread host([&] {
    if (by_clear) {
      bag.clear();
    } else {
      bag.erase(*key_frame);
    }
    forgotten = true;
    key_frame.reset();
  });
  while (bag.size() != 0) std::this_thread::yield();
  CHECK_FALSE(forgotten);
  let_go = true;
  query.join();
  host.join();
  CHECK(forgotten);
}

TEST_CASE("a refresh makes the graphs anew with the poses of now", "[adaptors]") {
  const SyntheticRoom room(7, 9, 4);
  std::mt19937 random(6);
  small_host::KeyFrame first(1, 0.0, random_camera(random)), second(2, 1.0, random_camera(random));
  KeyFrameBag<small_host::KeyFrame> bag({}, {});
  const Eigen::Isometry3d truth = host_pose(second.GetPoseInverse());
  for (small_host::KeyFrame* key_frame : {&first, &second}) {
    auto seen =
        small_host::sighting(room, key_frame->mTimeStamp, host_pose(key_frame->GetPoseInverse()));
    // Each sees half the room.
    const auto middle = seen.nodes.begin() + 5;
    seen.nodes = key_frame == &first ? decltype(seen.nodes)(seen.nodes.begin(), middle)
                                     : decltype(seen.nodes)(middle, seen.nodes.end());
    bag.observe(0, key_frame->mnId, seen);
  }
  second.SetPoseInverse(Eigen::Translation3d(1.0, 0.0, 0.0) * truth);
  bag.add(first);
  bag.add(second);
  const TopologyGraph<> query = room.seen_from(random_camera(random));
  const std::set<small_host::KeyFrame*> without_first{&first};
  const auto matched = [&] {
    const auto places = bag.places(query, without_first, {}, nullptr);
    return places.empty() ? 0.0 : places.front().score;
  };
  const double askew = matched();
  second.SetPoseInverse(truth);
  bag.refresh();
  CHECK(matched() > askew);
}
