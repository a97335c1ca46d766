// SPDX-License-Identifier: MIT
#include <atomic>
#include <chrono>
#include <cstddef>
#include <limits>
#include <memory>
#include <mutex>
#include <optional>
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
  bag.add(key_frame.get());
  REQUIRE(bag.size() == 1);
  key_frame->being_read = &being_read;
  key_frame->let_go = &let_go;

  std::thread query([&] { CHECK(!bag.places(room.seen_from(origin), {}).empty()); });
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
  bag.add(&first);
  bag.add(&second);
  const TopologyGraph<> query = room.seen_from(random_camera(random));
  const AskedKeyFrames<small_host::KeyFrame> without_first{{&first}};
  const auto matched = [&] {
    const auto places = bag.places(query, without_first);
    return places.empty() ? 0.0 : places.front().score;
  };
  const double askew = matched();
  second.SetPoseInverse(truth);
  bag.refresh();
  CHECK(matched() > askew);
}

TEST_CASE("the present visit, and those left out, are no places", "[adaptors]") {
  const SyntheticRoom room(7, 9, 4);
  const Eigen::Isometry3d origin = Eigen::Isometry3d::Identity();
  small_host::KeyFrame early(1, 0.0, origin), late(2, 50.0, origin);
  KeyFrameBag<small_host::KeyFrame> bag({}, {});
  for (small_host::KeyFrame* key_frame : {&early, &late}) {
    bag.add(key_frame);
    bag.observe(0, key_frame->mnId, small_host::sighting(room, key_frame->mTimeStamp, origin));
  }
  using KeyFrames = std::set<const small_host::KeyFrame*>;
  const auto found = [&](const KeyFrames& excluded, std::optional<double> newest) {
    AskedKeyFrames<small_host::KeyFrame> asked{excluded};
    if (newest) asked.not_of = {0, *newest};
    KeyFrames key_frames;
    for (const auto& place : bag.places(room.seen_from(origin), asked)) {
      key_frames.insert(place.key_frame);
    }
    return key_frames;
  };
  CHECK(found({}, {}) == KeyFrames{&early, &late});
  CHECK(found({}, 50.0) == KeyFrames{&early, &late});
  CHECK(found({}, 49.0) == KeyFrames{&early});
  CHECK(found({&early}, {}) == KeyFrames{&late});
  CHECK(found({&early}, 49.0).empty());
}

TEST_CASE("a refused sighting does not poison its neighbours", "[adaptors]") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const SyntheticRoom room(7, 9, 4);
  const Eigen::Isometry3d origin = Eigen::Isometry3d::Identity();
  small_host::KeyFrame first(1, 0.0, origin), second(2, 1.0, origin);
  KeyFrameBag<small_host::KeyFrame> bag({}, {});
  bag.add(&first);
  bag.add(&second);
  CHECK_THROWS_AS(bag.observe(0, 1, small_host::sighting(room, nan, origin)), InvalidValue);
  KeyframeSighting askew = small_host::sighting(room, 0.0, origin);
  askew.nodes[2].position->y() = nan;
  try {
    bag.observe(0, 1, askew);
    FAIL("a node that is not finite was taken");
  } catch (const InvalidValue& error) {
    CHECK(error.index() == 2u);
  }
  CHECK(bag.observe(0, 2, small_host::sighting(room, 1.0, origin)));
  CHECK(bag.size() == 1);
  CHECK(bag.observe(0, 1, small_host::sighting(room, 0.0, origin)));
  CHECK(bag.size() == 2);
}

TEST_CASE("a key frame that cannot be refreshed does not keep the others from it", "[adaptors]") {
  const SyntheticRoom room(7, 9, 4);
  std::mt19937 random(6);
  const Eigen::Isometry3d origin = Eigen::Isometry3d::Identity();
  small_host::KeyFrame before(1, 0.0, origin), lost(2, 1.0, origin), after(3, 50.0, origin);
  KeyFrameBag<small_host::KeyFrame> bag({}, {});
  for (small_host::KeyFrame* key_frame : {&before, &lost, &after}) {
    bag.add(key_frame);
    bag.observe(0, key_frame->mnId, small_host::sighting(room, key_frame->mTimeStamp, origin));
  }
  small_host::KeyFrame half(4, 51.0, origin);
  bag.add(&half);
  KeyframeSighting seen = small_host::sighting(room, 51.0, origin);
  seen.nodes.resize(4);
  bag.observe(0, 4, seen);
  const TopologyGraph<> query = room.seen_from(random_camera(random));
  const auto found = [&] {
    const auto places = bag.places(query, {{&before, &lost, &after}});
    return places.empty() ? 0.0 : places.front().score;
  };
  const double whole = found();
  // Far from the other, so that only a refresh tells.
  half.SetPoseInverse(Eigen::Isometry3d(Eigen::Translation3d(1.0, 0.5, 0.0)));
  Eigen::Isometry3d nowhere = origin;
  nowhere.translation().x() = std::numeric_limits<double>::quiet_NaN();
  lost.SetPoseInverse(nowhere);
  CHECK_THROWS_AS(bag.refresh(), InvalidValue);
  CHECK(found() < whole);
  CHECK(bag.size() == 4);
}

TEST_CASE("a filter of the host's own joins the bag's", "[adaptors]") {
  const SyntheticRoom room(7, 9, 4);
  const Eigen::Isometry3d origin = Eigen::Isometry3d::Identity();
  RecognitionOptions recognition;
  recognition.retrieval.filter = [](KeyframeId id, const EntryInfo&) { return value(id) != 1; };
  KeyFrameBag<small_host::KeyFrame> bag({}, recognition);
  small_host::KeyFrame first(1, 0.0, origin), second(2, 50.0, origin), third(3, 100.0, origin);
  for (small_host::KeyFrame* key_frame : {&first, &second, &third}) {
    bag.add(key_frame);
    bag.observe(0, key_frame->mnId, small_host::sighting(room, key_frame->mTimeStamp, origin));
  }
  const auto places = bag.places(room.seen_from(origin), {{&third}});
  CHECK_FALSE(places.empty());
  for (const auto& place : places) CHECK(place.key_frame == &second);
}

TEST_CASE("a reset ends the waiting for a sighting", "[adaptors]") {
  const std::chrono::seconds patience(20);
  KeyFrameBag<small_host::KeyFrame> bag({}, {});
  small_host::KeyFrame key_frame(1, 0.0, Eigen::Isometry3d::Identity());
  std::atomic<bool> ended{false};
  const auto begin = std::chrono::steady_clock::now();
  std::thread query([&] {
    CHECK_FALSE(bag.graph_of(&key_frame, patience));
    ended = true;
  });
  while (!ended) {  // the first may come before the query does
    bag.clear();
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  query.join();
  CHECK(std::chrono::steady_clock::now() - begin < patience);
}

TEST_CASE("the host says which way is down whenever a graph is made", "[adaptors][gravity]") {
  const SyntheticRoom room(7, 9, 4);
  std::mt19937 random(8);
  small_host::KeyFrame key_frame(1, 0.0, random_camera(random));
  std::size_t asked = 0;
  bool known = false;
  KeyFrameBag<small_host::KeyFrame> bag({}, {}, [&](small_host::KeyFrame& of) {
    ++asked;
    return known ? small_host::gravity_of(of) : std::nullopt;
  });
  bag.add(&key_frame);
  CHECK(asked == 0);
  bag.observe(0, 1, small_host::sighting(room, 0.0, host_pose(key_frame.GetPoseInverse())));
  CHECK(asked == 1);
  const auto gravity = [&] { return bag.graph_of(&key_frame, std::chrono::seconds(0))->gravity(); };
  CHECK_FALSE(gravity());
  known = true;
  for (int i = 0; i < 3; ++i) {
    key_frame.SetPoseInverse(random_camera(random));
    REQUIRE(gravity());
    const Eigen::Isometry3d T_world_camera = host_pose(key_frame.GetPoseInverse());
    CHECK((T_world_camera.linear() * gravity()->down).isApprox(Eigen::Vector3d::UnitY(), 1e-5));
    CHECK(gravity()->deviation == Approx(0.02));
  }
}

TEST_CASE("a sighting whose gravity says nothing is refused", "[adaptors][gravity]") {
  KeyFrameBag<small_host::KeyFrame> bag({}, {});
  KeyframeSighting seen;
  seen.gravity = Gravity<>{Eigen::Vector3d::Zero()};
  CHECK_THROWS_AS(bag.observe(0, 1, seen), InvalidValue);
  seen.gravity.reset();
  CHECK(bag.observe(0, 1, seen));
}

TEST_CASE("nobody waits for a sighting that was given up", "[adaptors][regression]") {
  small_host::KeyFrame dropped(1, 0.0, Eigen::Isometry3d::Identity()),
      culled(2, 0.0, Eigen::Isometry3d::Identity());
  KeyFrameBag<small_host::KeyFrame> bag({}, {});
  bag.give_up(0, 1);
  bag.erase(culled);
  const std::chrono::hours for_ever{1000};
  CHECK_FALSE(bag.graph_of(&dropped, for_ever));
  CHECK_FALSE(bag.graph_of(&culled, for_ever));
  small_host::KeyFrame late(3, 0.0, Eigen::Isometry3d::Identity());
  std::thread loop_closing([&] { CHECK_FALSE(bag.graph_of(&late, for_ever)); });
  bag.give_up(0, 3);
  loop_closing.join();
}
