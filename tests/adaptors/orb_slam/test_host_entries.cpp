// SPDX-License-Identifier: MIT
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <random>
#include <vector>

#include <topobag/adaptors/orb_slam/host_entries.hpp>
#include <topobag/recognition/place_graph.hpp>

#include "catch.hpp"
#include "recognition/synthetic_room.hpp"

using namespace topobag;

namespace {

Eigen::Isometry3d pose_in(const HostEntries<>& entries, std::uint64_t id) {
  return *entries.relocalizer().map().info(KeyframeId{id})->T_world_camera;
}

/// Key frames of a room from there, all of them in one map, at the poses at which they were taken.
void put_room(HostEntries<>& entries, const SyntheticRoom& room, std::uint64_t first_id,
              const std::vector<Eigen::Isometry3d>& cameras, const void* map) {
  for (std::size_t i = 0; i < cameras.size(); ++i) {
    entries.put(first_id + i, room.seen_from(cameras[i]), {}, {map, cameras[i]});
  }
}

}  // namespace

TEST_CASE("an entry stands where its graph was fused, and moves with its host", "[adaptors]") {
  const SyntheticRoom room(7, 9, 4);
  std::mt19937 random(5);
  HostEntries<> entries({});
  std::map<std::uint64_t, HostCamera> cameras;
  EntryInfo info;
  info.stamp = 3.0;
  info.session = 2;
  for (std::uint64_t id = 0; id < 10; ++id) {
    cameras[id].T_map_camera = random_camera(random);
    entries.put(id, room.seen_from(cameras[id].T_map_camera), info, cameras[id]);
  }
  const auto& bag = entries.relocalizer().map();
  for (int round = 0; round < 20; ++round) {
    for (auto& [id, camera] : cameras) {
      CHECK(pose_in(entries, id).matrix() == camera.T_map_camera.matrix());
      CHECK(bag.info(KeyframeId{id})->stamp == 3.0);
      CHECK(bag.info(KeyframeId{id})->session == 2);
      if (random() % 2 == 0) camera.T_map_camera = random_camera(random);
    }
    entries.move(cameras);
  }
  cameras[99].T_map_camera = random_camera(random);
  entries.move(cameras);
  CHECK(entries.size() == 10);
  entries.erase(4);
  entries.move(cameras);
  CHECK(entries.size() == 9);
  CHECK_FALSE(bag.contains(KeyframeId{4}));
}

TEST_CASE("one that cannot be matched comes in no bag, and into an older one's place",
          "[adaptors]") {
  const SyntheticRoom room(7, 9, 4);
  const HostCamera here{};
  HostEntries<> entries({});
  entries.put(1, {}, {}, here);
  CHECK(entries.size() == 0);
  entries.put(1, room.seen_from(here.T_map_camera), {}, here);
  CHECK(entries.size() == 1);
  entries.put(1, {}, {}, here);
  CHECK(entries.relocalizer().map().find(KeyframeId{1})->empty());
  entries.clear();
  CHECK(entries.size() == 0);
}

TEST_CASE("another map's objects at the same numbers are none of a place's", "[adaptors]") {
  const int here = 1, elsewhere = 2;
  std::size_t mixed = 0;
  for (unsigned seed = 0; seed < 10; ++seed) {
    const SyntheticRoom room(seed, 9, 4), other(100 + seed, 9, 4);
    std::mt19937 random(seed);
    std::vector<Eigen::Isometry3d> cameras, other_cameras;
    for (int i = 0; i < 6; ++i) {
      cameras.push_back(random_camera(random));
      other_cameras.push_back(random_camera(random));
    }
    const TopologyGraph<> query = room.seen_from(cameras[0]);
    const auto objects_of_place = [&](const void* map_of_other) {
      HostEntries<> entries({});
      put_room(entries, room, 0, cameras, &here);
      put_room(entries, other, 100, other_cameras, map_of_other);
      return place_graph(entries.relocalizer().map(), KeyframeId{0}, query, query,
                         Eigen::Isometry3d::Identity())
          .size();
    };
    CHECK(objects_of_place(&elsewhere) == query.size());
    mixed += objects_of_place(&here) > query.size() ? 1U : 0U;
  }
  CHECK(mixed > 5);  // what it would be if they shared a world
}

TEST_CASE("places of two maps are two, whatever their numbers", "[adaptors]") {
  const int here = 1, elsewhere = 2;
  const SyntheticRoom room(7, 9, 4);
  const std::vector<Eigen::Isometry3d> cameras(3, Eigen::Isometry3d::Identity());
  HostEntries<> entries({});
  put_room(entries, room, 0, cameras, &here);
  CHECK(entries.relocalizer().map().places() == 1);
  put_room(entries, room, 100, cameras, &elsewhere);
  CHECK(entries.relocalizer().map().places() == 2);
  std::map<std::uint64_t, HostCamera> merged;
  for (std::uint64_t id = 100; id < 103; ++id) merged[id] = {&here, cameras[id - 100]};
  entries.move(merged);
  CHECK(entries.relocalizer().map().places() == 1);
}
