// SPDX-License-Identifier: MIT
// A map on disk is a bag as every other: looked up in, grown, moved and merged.
#include <cstdint>
#include <random>
#include <string>

#include <topobag/adaptors/sqlite.hpp>
#include <topobag/bag/indexed_bag.hpp>
#include <topobag/graph/scaled_graph.hpp>
#include <topobag/recognition/loop_detector.hpp>

#include "adaptors/sqlite_maps.hpp"
#include "bag/moved_poses.hpp"
#include "bag/reading_calls.hpp"
#include "catch.hpp"
#include "recognition/synthetic_room.hpp"
#include "scratch_folder.hpp"

using namespace topobag;

static_assert(is_searchable_bag_v<SqliteBag<>> && is_growing_bag_v<SqliteBag<>>);
static_assert(is_stored_bag_v<SqliteBag<>> && is_durable_bag_v<SqliteBag<>>);

TEST_CASE("a map on disk has every reading call", "[sqlite]") {
  CHECK(missing_calls_of<SqliteBag<>>() == "");
  CHECK(missing_calls_of<SqliteBag<IndexedBag>>() == "");
}

TEST_CASE("loops are found in a map on disk as in one in memory, without a copy", "[sqlite]") {
  const ScratchFolder folder;
  SqliteBag<IndexedBag> map(folder.path("map.db"));
  IndexedBag memory;
  LoopDetector durable(map);
  LoopDetector in_memory(memory);
  std::mt19937 random(3);
  std::size_t loops = 0;
  for (unsigned i = 0; i < 60; ++i) {
    const auto T_world_camera = random_camera(random);
    const auto seen = SyntheticRoom(i % 3, 10, 8).seen_from(T_world_camera);
    const auto info = standing_at(Eigen::Translation3d(50.0 * (i % 3), 0, 0) * T_world_camera);
    const Recognition a = durable.detect_and_add(KeyframeId{i}, i, seen, info);
    const Recognition b = in_memory.detect_and_add(KeyframeId{i}, i, seen, info);
    REQUIRE(a.accepted.has_value() == b.accepted.has_value());
    if (!a) continue;
    ++loops;
    CHECK(a.accepted->id == b.accepted->id);
    CHECK(a.accepted->margin() == Approx(b.accepted->margin()));  // a pose is rounded on disk
    CHECK(durable.T_world_query(a)->T.isApprox(in_memory.T_world_query(b)->T, 1e-9));
  }
  CHECK(loops > 20);
  CHECK(map.size() == 60);
  CHECK(&durable.bag() == &map);
  // Read again, by who only looks up.
  const SqliteBag<> reader(folder.path("map.db"), read_only());
  const Relocalizer relocalizer(reader);
  const auto query = SyntheticRoom(1, 10, 8).seen_from(random_camera(random));
  REQUIRE(relocalizer.localize(query));
  CHECK(value(relocalizer.localize(query).accepted->id) % 3 == 1);
  CHECK(reader.places() == memory.places());
}

TEST_CASE("set_poses of a map on disk is an update of each key frame, also when read again",
          "[sqlite]") {
  const ScratchFolder folder;
  std::mt19937 random(4);
  {
    SqliteBag<> moved(folder.path("moved.db")), updated(folder.path("updated.db"));
    check_set_poses(moved, updated, 40);
    CHECK(moved.within({{0.0, 0.0, 0.0}, 100.0}) == updated.within({{0.0, 0.0, 0.0}, 100.0}));
  }
  const SqliteBag<> moved(folder.path("moved.db"), read_only());
  const SqliteBag<> updated(folder.path("updated.db"), read_only());
  check_same_map(moved, updated, random);
}

TEST_CASE("a map on disk takes in another, with the names of its runs", "[sqlite]") {
  const ScratchFolder folder;
  SqliteBag<> ours(folder.path("ours.db")), theirs(folder.path("theirs.db"));
  std::mt19937 random(5);
  EntryInfo info;
  info.session = ours.begin_session("Monday");
  for (const std::uint64_t id : {1U, 2U}) ours.add(KeyframeId{id}, random_graph(random, 4), info);
  theirs.begin_session("Tuesday");
  info.session = theirs.begin_session("Wednesday");
  info.T_world_camera = Eigen::Isometry3d::Identity();
  for (const std::uint64_t id : {2U, 7U}) theirs.add(KeyframeId{id}, random_graph(random, 5), info);
  MergeOptions options;
  options.session_offset = 1;
  options.T_world_other = Eigen::Isometry3d(Eigen::Translation3d(0, 0, 9));
  const auto ids = ours.merge(theirs, options);
  CHECK(ids.at(KeyframeId{2}) == KeyframeId{8});
  CHECK(ids.at(KeyframeId{7}) == KeyframeId{7});
  const SqliteBag<> again(folder.path("ours.db"), read_only());
  const SqliteBag<>* const maps[] = {&ours, &again};
  for (const SqliteBag<>* map : maps) {
    CHECK(map->size() == 4);
    CHECK(encode(*map->find(KeyframeId{8})) == encode(*theirs.find(KeyframeId{2})));
    CHECK(map->info(KeyframeId{8})->session == 2);
    CHECK(map->info(KeyframeId{8})->T_world_camera->translation().z() == 9.0);
    const auto sessions = map->sessions();
    REQUIRE(sessions.size() == 3);
    CHECK(sessions[0].name == "Monday");
    CHECK(sessions[1].name == "Tuesday");
    CHECK(sessions[2].name == "Wednesday");
  }
}

TEST_CASE("a map on disk takes in one of another unit in its own", "[sqlite]") {
  const ScratchFolder folder;
  SqliteBag<> ours(folder.path("ours.db"));
  std::mt19937 random(6);
  BagOfTopologyGraphs<> theirs;
  for (const std::uint64_t id : {2U, 7U}) {
    theirs.add(KeyframeId{id}, decode(encode(random_graph(random, 5))),
               standing_at(Eigen::Isometry3d(Eigen::Translation3d(0, 0, 2))));
  }
  MergeOptions options;
  options.scale = 1.6;
  options.T_world_other = Eigen::Isometry3d(Eigen::Translation3d(0, 0, 9));
  ours.merge(theirs, options);
  const SqliteBag<> again(folder.path("ours.db"), read_only());
  for (const std::uint64_t id : {2U, 7U}) {
    CHECK(encode(*again.find(KeyframeId{id})) == encode(scaled(*theirs.find(KeyframeId{id}), 1.6)));
    CHECK(again.info(KeyframeId{id})->T_world_camera->translation().z() == Approx(12.2));
  }
  options.scale = 0.0;
  CHECK_THROWS_AS(ours.merge(theirs, options), InvalidValue);
  CHECK(ours.size() == 2);
}
