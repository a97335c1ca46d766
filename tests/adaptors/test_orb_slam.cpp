// SPDX-License-Identifier: MIT
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <random>
#include <stdexcept>
#include <thread>
#include <vector>

#include <topobag/adaptors/orb_slam.hpp>

#include "adaptors/small_database.hpp"
#include "adaptors/small_host.hpp"
#include "catch.hpp"

using namespace topobag;
using namespace small_host;

namespace {

using Pointers = std::vector<KeyFrame*>;

/// A room, and a database that knows what a lost frame sees.
struct Host {
  SyntheticRoom room{7, 9, 4};
  std::mt19937 random{3};
  std::vector<std::unique_ptr<KeyFrame>> key_frames;
  Database database{without_waiting(), [this](const Frame& frame) {
                      return std::optional<TopologyGraph<>>(room.seen_from(frame.T_world_camera));
                    }};

  KeyFrame& make(unsigned long id, double stamp) {
    key_frames.push_back(std::make_unique<KeyFrame>(id, stamp, random_camera(random)));
    return *key_frames.back();
  }
  KeyframeSighting seen_in(const KeyFrame& key_frame) const {
    return sighting(room, key_frame.mTimeStamp, host_pose(key_frame.GetPoseInverse()));
  }
  bool observe(const KeyFrame& key_frame) {
    return database.observe(database.epoch(), key_frame.mnId, seen_in(key_frame));
  }
  KeyFrame& mapped(unsigned long id, double stamp) {
    KeyFrame& key_frame = make(id, stamp);
    observe(key_frame);
    database.add(&key_frame);
    return key_frame;
  }
};

double apart(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b) {
  return (a.inverse() * b).translation().norm();
}

}  // namespace

TEST_CASE("a key frame is found once its pointer and its sighting are there", "[adaptors]") {
  const bool pointer_first = GENERATE(false, true);
  Host host;
  KeyFrame& key_frame = host.make(1, 0.0);
  Frame frame{9.0, random_camera(host.random)};
  if (pointer_first) host.database.add(&key_frame);
  if (!pointer_first) host.observe(key_frame);
  CHECK(host.database.size() == 0);
  CHECK(host.database.DetectRelocalizationCandidates(&frame).empty());
  if (pointer_first) host.observe(key_frame);
  if (!pointer_first) host.database.add(&key_frame);
  CHECK(host.database.size() == 1);
  CHECK(host.database.DetectRelocalizationCandidates(&frame) == Pointers{&key_frame});
}

TEST_CASE("a re-localization's pose follows the candidate's present pose", "[adaptors]") {
  Host host;
  KeyFrame& key_frame = host.mapped(1, 0.0);
  const Frame frame{9.0, random_camera(host.random)};
  const auto places = host.database.relocalization_places(frame);
  REQUIRE(!places.empty());
  CHECK(places.front().verified);
  CHECK(apart(places.front().T_world_query, frame.T_world_camera) < 1e-3);

  const Eigen::Isometry3d correction(Eigen::Translation3d(1.0, 2.0, 3.0));
  key_frame.SetPoseInverse(correction * host_pose(key_frame.GetPoseInverse()));
  const auto corrected = host.database.relocalization_places(frame);
  REQUIRE(!corrected.empty());
  CHECK(apart(corrected.front().T_world_query, correction * frame.T_world_camera) < 1e-3);
  const PlainPose T_camera_world = corrected.front().camera_pose();
  const Eigen::Matrix4d expected = (correction * frame.T_world_camera).inverse().matrix();
  CHECK(std::abs(static_cast<double>(T_camera_world[11]) - expected(2, 3)) < 1e-3);
}

TEST_CASE("loop candidates leave out the key frame, its covisible ones and the bad", "[adaptors]") {
  Host host;
  KeyFrame& old = host.mapped(1, 0.0);
  KeyFrame& covisible = host.mapped(2, 50.0);
  KeyFrame& bad = host.mapped(3, 60.0);
  KeyFrame& now = host.mapped(4, 100.0);
  now.AddConnection(&covisible);
  bad.SetBadFlag();
  CHECK(host.database.DetectLoopCandidates(&now, 0.1F) == Pointers{&old});
  CHECK(host.database.size() == 4);
}

TEST_CASE("a loop query before the key frame is added sees its sighting", "[adaptors]") {
  Host host;
  KeyFrame& old = host.mapped(1, 0.0);
  KeyFrame& now = host.make(2, 50.0);
  CHECK(host.database.DetectLoopCandidates(&now, 0.0F).empty());
  host.observe(now);
  CHECK(host.database.DetectLoopCandidates(&now, 0.0F) == Pointers{&old});
}

TEST_CASE("a loop query waits for its sighting", "[adaptors]") {
  OrbSlamOptions options;
  options.loop_wait = std::chrono::minutes(1);
  Host host;
  Database database(options);
  KeyFrame& old = host.make(1, 0.0);
  KeyFrame& now = host.make(2, 50.0);
  database.add(&old);
  database.observe(0, 1, host.seen_in(old));
  std::thread detector([&] { database.observe(0, 2, host.seen_in(now)); });
  CHECK(database.DetectLoopCandidates(&now, 0.0F) == Pointers{&old});
  detector.join();
}

TEST_CASE("a loop's least gap in time is kept", "[adaptors]") {
  OrbSlamOptions options = without_waiting();
  options.min_loop_gap = 20.0;
  options.fusing.window = 0.0;
  Host host;
  Database database(options);
  for (const double stamp : {0.0, 70.0, 81.0, 100.0}) {
    KeyFrame& key_frame = host.make(host.key_frames.size(), stamp);
    database.observe(0, key_frame.mnId, host.seen_in(key_frame));
    database.add(&key_frame);
  }
  Pointers found = database.DetectLoopCandidates(host.key_frames[3].get(), 0.0F);
  std::sort(found.begin(), found.end(), [](auto* a, auto* b) { return a->mnId < b->mnId; });
  CHECK(found == Pointers{host.key_frames[0].get(), host.key_frames[1].get()});
}

TEST_CASE("no more places are offered than asked for", "[adaptors]") {
  OrbSlamOptions options = without_waiting();
  options.fusing.window = 0.0;
  options.max_loops = options.max_relocalizations = 1;
  Host host;
  Database database(options, [&](const Frame& frame) {
    return std::optional<TopologyGraph<>>(host.room.seen_from(frame.T_world_camera));
  });
  for (const double stamp : {0.0, 50.0, 100.0}) {
    KeyFrame& key_frame = host.make(host.key_frames.size(), stamp);
    database.observe(0, key_frame.mnId, host.seen_in(key_frame));
    database.add(&key_frame);
  }
  CHECK(database.relocalization_places({9.0, random_camera(host.random)}).size() == 1);
  CHECK(database.loop_places(host.key_frames[2].get()).size() == 1);
}

TEST_CASE("the host's candidates follow the verified ones, each once, none bad", "[adaptors]") {
  Host host;
  KeyFrame& ours = host.mapped(1, 0.0);
  KeyFrame& theirs = host.make(2, 1.0);
  KeyFrame& bad = host.make(3, 2.0);
  bad.SetBadFlag();
  Frame frame{9.0, random_camera(host.random)};
  CHECK(host.database.DetectRelocalizationCandidates(&frame, {&theirs, &bad, &ours, nullptr}) ==
        Pointers{&ours, &theirs});
}

TEST_CASE("an erased key frame is gone, also when it was erased before it came", "[adaptors]") {
  Host host;
  KeyFrame& erased = host.mapped(1, 0.0);
  KeyFrame& early = host.make(2, 1.0);
  Frame frame{9.0, random_camera(host.random)};
  host.database.erase(&erased);
  host.database.erase(&early);
  CHECK(host.database.size() == 0);
  CHECK_FALSE(host.observe(early));
  host.database.add(&early);
  CHECK(host.database.size() == 0);
  CHECK(host.database.DetectRelocalizationCandidates(&frame).empty());
}

TEST_CASE("after a reset ids restart and late sightings of before are refused", "[adaptors]") {
  Host host;
  KeyFrame& before = host.mapped(1, 0.0);
  const KeyframeSighting late = host.seen_in(before);
  host.database.erase(&before);
  const std::uint64_t epoch = host.database.epoch();
  host.database.clear();
  CHECK(host.database.size() == 0);
  CHECK_FALSE(host.database.observe(epoch, 1, late));
  host.mapped(1, 0.0);
  CHECK(host.database.size() == 1);
}

TEST_CASE("what goes wrong is counted and not thrown at the host", "[adaptors]") {
  Host host;
  Database throwing(without_waiting(), [](const Frame&) -> std::optional<TopologyGraph<>> {
    throw std::runtime_error("no detector");
  });
  Frame frame;
  KeyFrame& theirs = host.make(2, 1.0);
  CHECK(throwing.DetectRelocalizationCandidates(&frame, {&theirs}) == Pointers{&theirs});
  CHECK(throwing.failures().first == 1);
  CHECK(throwing.failures().second == "no detector");

  Database odd(without_waiting(), [](const Frame&) -> std::optional<TopologyGraph<>> { throw 7; });
  CHECK(odd.DetectRelocalizationCandidates(&frame, {&theirs}) == Pointers{&theirs});
  CHECK(odd.failures().first == 1);
  CHECK(odd.failures().second == "the call threw something that is not a std::exception");

  KeyFrame& askew = host.make(1, 0.0);
  KeyframeSighting broken = host.seen_in(askew);
  broken.nodes[2].position = Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
  host.database.add(&askew);
  CHECK_FALSE(host.database.observe(0, 1, broken));
  CHECK(host.database.failures().first == 1);
  CHECK(host.database.size() == 0);
  CHECK(host.observe(askew));
  CHECK(host.database.size() == 1);
}

TEST_CASE("a host's gravity that says nothing is counted, and a later one mends it",
          "[adaptors][gravity]") {
  Host host;
  std::optional<Gravity<>> said = Gravity<>{Eigen::Vector3d::Zero()};
  std::size_t asked = 0;
  Database database(without_waiting(), {}, [&](KeyFrame&) {
    ++asked;
    return said;
  });
  KeyFrame& key_frame = host.make(1, 0.0);
  database.observe(0, 1, host.seen_in(key_frame));
  database.add(&key_frame);
  CHECK(asked == 1);
  CHECK(database.size() == 0);
  CHECK(database.failures().first == 1);
  said = gravity_of(key_frame);
  database.refresh();
  CHECK(asked == 2);
  CHECK(database.size() == 1);
  CHECK(database.failures().first == 1);
}
