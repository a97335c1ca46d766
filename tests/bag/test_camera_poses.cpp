// SPDX-License-Identifier: MIT
#include <topobag/bag/camera_poses.hpp>

#include <random>

#include <topobag/bag/bag_of_topology_graphs.hpp>
#include <topobag/bag/graph_codec.hpp>
#include <topobag/bag/indexed_bag.hpp>

#include "catch.hpp"
#include "moved_poses.hpp"

using namespace topobag;

TEST_CASE("set_poses of a plain bag is an update of each key frame", "[bag]") {
  BagOfTopologyGraphs<> moved, updated;
  check_set_poses(moved, updated, 60);
}

TEST_CASE("set_poses of an indexed bag is an update of each key frame", "[bag][index]") {
  IndexedBag moved, updated;  // 300: some sealed, some in the head
  check_set_poses(moved, updated, 300);
}

TEST_CASE("set_poses moves what later changes find", "[bag]") {
  std::mt19937 random(12);
  IndexedBag bag;
  BagOfTopologyGraphs<> plain;
  for (std::uint64_t id = 0; id < 200; ++id) {
    EntryInfo info;
    info.T_world_camera = camera_in_flat(random);
    const auto graph = decode(encode(random_graph(random, 4, 4, false)));  // as `bag` keeps it
    bag.add(KeyframeId{id}, graph, info);
    plain.add(KeyframeId{id}, graph, info);
  }
  CameraPoses poses;
  for (std::uint64_t id = 0; id < 200; ++id) poses.emplace(KeyframeId{id}, camera_in_flat(random));
  bag.set_poses(poses);
  plain.set_poses(poses);
  for (std::uint64_t id = 0; id < 200; id += 3) {
    bag.erase(KeyframeId{id});
    plain.erase(KeyframeId{id});
  }
  check_same_map(bag, plain, random);
  bag.compact();
  check_same_map(bag, plain, random);
}

TEST_CASE("a reader sees the poses of the moment at which it began", "[bag]") {
  const Eigen::Isometry3d before = Eigen::Isometry3d::Identity();
  const Eigen::Isometry3d after(Eigen::Translation3d(1, 0, 0));
  EntryInfo info;
  info.T_world_camera = before;
  IndexedBag indexed;
  BagOfTopologyGraphs<> plain;
  for (const std::uint64_t id : {1U, 2U}) {
    indexed.add(KeyframeId{id}, {}, info);
    plain.add(KeyframeId{id}, {}, info);
  }
  const auto view = indexed.view();
  indexed.set_poses({{KeyframeId{1}, after}});
  CHECK(view->info(KeyframeId{1})->T_world_camera->matrix() == before.matrix());
  CHECK(indexed.info(KeyframeId{1})->T_world_camera->matrix() == after.matrix());
  plain.for_each([&](KeyframeId id, const EntryInfo& seen, const TopologyGraph<>&) {
    plain.set_poses({{KeyframeId{2}, after}, {id, after}});
    CHECK(seen.T_world_camera->matrix() == before.matrix());
  });
  CHECK(plain.info(KeyframeId{2})->T_world_camera->matrix() == after.matrix());
}
