// SPDX-License-Identifier: MIT
#include <cstddef>
#include <memory>
#include <optional>
#include <random>
#include <vector>

#include <Eigen/Geometry>

#include <topobag/adaptors/orb_slam.hpp>

#include "adaptors/small_database.hpp"
#include "adaptors/small_host.hpp"
#include "catch.hpp"
#include "recognition/bearings_of.hpp"

using namespace topobag;

namespace {

/// A room with key frames in it, and a camera that is lost in it, some of whose objects have a
/// depth.
struct LostCamera {
  explicit LostCamera(std::size_t with_depth) : objects_with_depth(with_depth) {
    for (unsigned long id = 1; id <= 3; ++id) {
      key_frames.push_back(std::make_unique<small_host::KeyFrame>(id, static_cast<double>(id),
                                                                  random_camera(random)));
      database.observe(0, id,
                       small_host::sighting(room, static_cast<double>(id),
                                            host_pose(key_frames.back()->GetPoseInverse())));
      database.add(key_frames.back().get());
    }
  }

  LostSight sees(const Eigen::Isometry3d& T_world_camera) {
    auto nodes = room.seen_from(T_world_camera).nodes();
    std::mt19937 noise(5);
    LostSight seen(std::nullopt, bearings_of(TopologyGraph<>(nodes), noise, 1e-3));
    if (!knows_directions) seen.bearings.reset();
    nodes.resize(objects_with_depth);
    if (objects_with_depth > 0) seen.graph.emplace(std::move(nodes));
    return seen;
  }

  std::size_t objects_with_depth;
  bool knows_directions = true;
  SyntheticRoom room{4, 9, 9};
  std::mt19937 random{3};
  std::vector<std::unique_ptr<small_host::KeyFrame>> key_frames;
  small_host::Database database{
      small_host::without_waiting(),
      [this](const small_host::Frame& frame) { return sees(frame.T_world_camera); }};
};

}  // namespace

TEST_CASE("a lost camera without depth is found by the objects' directions", "[adaptors]") {
  for (const std::size_t with_depth : {0U, 2U}) {
    LostCamera lost(with_depth);
    for (int round = 0; round < 5; ++round) {
      const small_host::Frame frame{9.0, random_camera(lost.random)};
      const auto places = lost.database.relocalization_places(frame);
      CAPTURE(with_depth, round);
      REQUIRE_FALSE(places.empty());
      CHECK(places.front().verified);
      for (const auto& place : places) CHECK(place.by_bearings);
      const Eigen::Isometry3d off = places.front().T_world_query.inverse() * frame.T_world_camera;
      CHECK(off.translation().norm() < 0.1);
      CHECK(Eigen::AngleAxisd(off.linear()).angle() < 0.05);
    }
    CHECK(lost.database.failures().first == 0);
  }
}

TEST_CASE("with depth, directions are not asked", "[adaptors]") {
  LostCamera lost(9);
  const small_host::Frame frame{9.0, random_camera(lost.random)};
  const auto places = lost.database.relocalization_places(frame);
  REQUIRE_FALSE(places.empty());
  CHECK(places.front().verified);
  for (const auto& place : places) CHECK_FALSE(place.by_bearings);
}

TEST_CASE("without depth and without directions nothing is found", "[adaptors]") {
  for (const std::size_t with_depth : {0U, 2U}) {
    LostCamera lost(with_depth);
    lost.knows_directions = false;
    CHECK(lost.database.relocalization_places({9.0, random_camera(lost.random)}).empty());
    CHECK(lost.database.failures().first == 0);
  }
}

TEST_CASE("key frames that are gone are not found by directions either", "[adaptors]") {
  LostCamera lost(0);
  for (const auto& key_frame : lost.key_frames) lost.database.erase(key_frame.get());
  CHECK(lost.database.relocalization_places({9.0, random_camera(lost.random)}).empty());
}

TEST_CASE("what a lost frame shows is without depth where three objects have none", "[adaptors]") {
  const TopologyGraph<> room = SyntheticRoom(4, 9, 9).seen_from(Eigen::Isometry3d::Identity());
  const auto first = [&](std::size_t count) {
    return TopologyGraph<>({room.nodes().begin(), room.nodes().begin() + static_cast<int>(count)});
  };
  CHECK_FALSE(LostSight().is_without_depth());
  CHECK_FALSE(LostSight(first(2)).is_without_depth());
  CHECK(LostSight(std::nullopt, BearingSighting{}).is_without_depth());
  CHECK(LostSight(first(2), BearingSighting{}).is_without_depth());
  CHECK_FALSE(LostSight(first(3), BearingSighting{}).is_without_depth());
}
