// SPDX-License-Identifier: MIT
#include <algorithm>
#include <memory>
#include <optional>
#include <random>
#include <vector>

#include <topobag/adaptors/orb_slam.hpp>

#include "adaptors/atlas_host.hpp"
#include "adaptors/small_database.hpp"
#include "catch.hpp"

using namespace topobag;

namespace {

/// Every key frame has its own graph, and is matched.
OrbSlamOptions all_candidates() {
  OrbSlamOptions options = atlas_host::single_frames();
  options.recognition.retrieval.max_results = 64;
  return options;
}

/// Visits to one room by a host with one map, long apart by their ids, and a camera lost in it.
struct PosedHost {
  explicit PosedHost(unsigned seed)
      : room(seed, 9, 4),
        random(seed),
        database(all_candidates(), [this](const small_host::Frame& frame) {
          return std::optional<TopologyGraph<>>(room.seen_from(frame.T_world_camera));
        }) {}

  /// @param T_world_room  where the host believes the room to be
  void visit(unsigned long first_id, const Eigen::Isometry3d& T_world_room) {
    for (unsigned long id = first_id; id < first_id + 5; ++id) {
      const Eigen::Isometry3d T_room_camera = random_camera(random);
      const auto stamp = static_cast<double>(id);
      key_frames.push_back(
          std::make_unique<small_host::KeyFrame>(id, stamp, T_world_room * T_room_camera));
      database.observe(0, id, small_host::sighting(room, stamp, T_room_camera));
      database.add(key_frames.back().get());
    }
  }

  /// Whether the lost camera is found for sure.
  bool finds() {
    const auto places = database.relocalization_places({0.0, random_camera(random)});
    return std::any_of(places.begin(), places.end(), [](const auto& at) { return at.verified; });
  }

  SyntheticRoom room;
  std::mt19937 random;
  std::vector<std::unique_ptr<small_host::KeyFrame>> key_frames;
  small_host::Database database;
};

}  // namespace

TEST_CASE("a map that stays about one spot does not rival itself", "[adaptors]") {
  const Eigen::Isometry3d origin = Eigen::Isometry3d::Identity();
  for (unsigned seed = 0; seed < 20; ++seed) {
    PosedHost host(seed);
    for (unsigned long id = 0; id < 500; id += 100) host.visit(id, origin);
    CHECK(host.finds());
  }
}

TEST_CASE("after a loop was closed its ends are one place, with no graph made anew", "[adaptors]") {
  const Eigen::Isometry3d drift(Eigen::Translation3d(4.0, -1.0, 0.0));
  for (unsigned seed = 0; seed < 20; ++seed) {
    PosedHost host(seed);
    host.visit(0, Eigen::Isometry3d::Identity());
    CHECK(host.finds());
    host.visit(500, drift);
    CHECK_FALSE(host.finds());
    for (const auto& key_frame : host.key_frames) {
      if (key_frame->mnId < 500) continue;
      key_frame->SetPoseInverse(drift.inverse() * host_pose(key_frame->GetPoseInverse()));
    }
    CHECK_FALSE(host.finds());
    CHECK(host.database.refresh_changed() == 0);
    CHECK(host.finds());
  }
}

TEST_CASE("fusing anew takes the poses of now", "[adaptors]") {
  const bool all = GENERATE(false, true);
  OrbSlamOptions options = all_candidates();
  options.fusing.window = 10.0;
  options.recognition.retrieval.among.region = MapRegion{{100.0, 0.0, 0.0}, 10.0};
  const SyntheticRoom room(7, 9, 4);
  std::mt19937 random(7);
  small_host::Database database(options, [&](const small_host::Frame& frame) {
    return std::optional<TopologyGraph<>>(room.seen_from(frame.T_world_camera));
  });
  std::vector<std::unique_ptr<small_host::KeyFrame>> key_frames;
  for (unsigned long id = 0; id < 3; ++id) {
    const Eigen::Isometry3d T = random_camera(random);
    key_frames.push_back(std::make_unique<small_host::KeyFrame>(id, 1.0, T));
    database.observe(0, id, small_host::sighting(room, 1.0, T));
    database.add(key_frames.back().get());
  }
  const small_host::Frame frame{0.0, random_camera(random)};
  CHECK(database.relocalization_places(frame).empty());
  key_frames[2]->SetPoseInverse(Eigen::Isometry3d(Eigen::Translation3d(100.0, 0.0, 0.0)));
  if (all) {
    database.refresh();
  } else {
    CHECK(database.refresh_changed() > 0);
  }
  const auto places = database.relocalization_places(frame);
  REQUIRE_FALSE(places.empty());
  for (const auto& place : places) CHECK(place.key_frame == key_frames[2].get());
}

TEST_CASE("two maps with the same numbers are not taken for one, until they are merged",
          "[adaptors]") {
  for (unsigned seed = 0; seed < 20; ++seed) {
    atlas_host::Session session(seed, all_candidates());
    for (int i = 0; i < 6; ++i) session.mapped(i, i % 2 == 0 ? session.first : session.second);
    const auto verified = [&](const atlas_host::Map* map) {
      const auto places =
          session.database.relocalization_places({random_camera(session.random)}, map);
      return std::any_of(places.begin(), places.end(), [](const auto& at) { return at.verified; });
    };
    CHECK(verified(&session.first));
    CHECK(verified(&session.second));
    CHECK_FALSE(verified(nullptr));  // which of the two, nothing tells
    for (const auto& key_frame : session.key_frames) key_frame->map = &session.first;
    CHECK(session.database.refresh_changed() == 0);
    CHECK(verified(nullptr));
  }
}
