// SPDX-License-Identifier: MIT
#include <random>
#include <type_traits>

#include <topobag/bag/indexed_bag.hpp>
#include <topobag/evaluation/pose_error.hpp>
#include <topobag/recognition/relocalizer.hpp>

#include "catch.hpp"
#include "error_text.hpp"
#include "random_graphs.hpp"
#include "synthetic_room.hpp"

using namespace topobag;

TEST_CASE("a camera is found in the room it is in, at its pose", "[recognition]") {
  std::mt19937 random(1);
  Relocalizer<> relocalizer;
  std::vector<SyntheticRoom> rooms;
  std::vector<Eigen::Isometry3d> cameras;
  for (unsigned i = 0; i < 12; ++i) {
    rooms.emplace_back(i, 10, 6);
    cameras.push_back(random_camera(random));
    EntryInfo info;
    info.T_world_camera = cameras[i];
    relocalizer.map().add(KeyframeId{i}, rooms[i].seen_from(cameras[i]), info);
  }
  for (unsigned i = 0; i < 12; ++i) {
    const Eigen::Isometry3d T_room_query = random_camera(random);
    const Recognition found = relocalizer.localize(rooms[i].seen_from(T_room_query));
    CAPTURE(i);
    REQUIRE(found);
    CHECK(found.accepted->id == KeyframeId{i});
    const PoseError relative =
        pose_error(cameras[i].inverse() * T_room_query, found.accepted->pose->T_candidate_query);
    CHECK(relative.translation_m < 1e-3);
    CHECK(relative.rotation_deg < 0.1);
    REQUIRE(relocalizer.T_world_query(found));
    const PoseError world = pose_error(T_room_query, *relocalizer.T_world_query(found));
    CHECK(world.translation_m < 1e-3);
    CHECK(world.rotation_deg < 0.1);
  }
}

TEST_CASE("a camera in a room that is not in the map is not found", "[recognition]") {
  std::mt19937 random(2);
  Relocalizer<> relocalizer;
  for (unsigned i = 0; i < 12; ++i) {
    relocalizer.map().add(KeyframeId{i}, SyntheticRoom(i, 8, 6).seen_from(random_camera(random)));
  }
  for (unsigned i = 0; i < 12; ++i) {
    const Recognition found =
        relocalizer.localize(SyntheticRoom(1000 + i, 8, 6).seen_from(random_camera(random)));
    CAPTURE(i);
    CHECK_FALSE(found);
    CHECK(found.usable);
    CHECK(found.candidates.size() == 12);
    CHECK_FALSE(relocalizer.T_world_query(found));
  }
}

TEST_CASE("the answer does not depend on the order of nodes or of entries", "[recognition]") {
  std::mt19937 random(4);
  const SyntheticRoom room(7, 9, 4);
  const TopologyGraph<> a = room.seen_from(random_camera(random));
  const TopologyGraph<> b = room.seen_from(random_camera(random));
  const TopologyGraph<> query = room.seen_from(random_camera(random));
  Relocalizer<> forth, back;
  forth.map().add(KeyframeId{1}, a);
  forth.map().add(KeyframeId{2}, b);
  back.map().add(KeyframeId{2}, b);
  back.map().add(KeyframeId{1}, a);
  const Recognition one = forth.localize(query);
  REQUIRE(one);
  const Recognition two = back.localize(query);
  CHECK(two.accepted->id == one.accepted->id);
  CHECK(two.accepted->pose->T_candidate_query.matrix() ==
        one.accepted->pose->T_candidate_query.matrix());
  const Recognition three = forth.localize(permuted(query, random_order(random, query.size())));
  REQUIRE(three);
  CHECK(three.accepted->pose->T_candidate_query.isApprox(one.accepted->pose->T_candidate_query,
                                                         1e-6));
}

TEST_CASE("at most retrieval.max_results are matched", "[recognition]") {
  std::mt19937 random(5);
  RecognitionOptions options;
  options.retrieval.max_results = 3;
  Relocalizer<> relocalizer(options);
  const SyntheticRoom room(1, 8, 8);
  for (unsigned i = 0; i < 6; ++i) {
    relocalizer.map().add(KeyframeId{i}, room.seen_from(random_camera(random)));
  }
  CHECK(relocalizer.localize(room.seen_from(random_camera(random))).candidates.size() == 3);
}

TEST_CASE("without a pose in the map there is none in the world", "[recognition]") {
  std::mt19937 random(6);
  Relocalizer<> relocalizer;
  const SyntheticRoom room(1, 8, 8);
  relocalizer.map().add(KeyframeId{1}, room.seen_from(random_camera(random)));
  const Recognition found = relocalizer.localize(room.seen_from(random_camera(random)));
  REQUIRE(found);
  CHECK_FALSE(relocalizer.T_world_query(found));
}

TEST_CASE("a map that lives elsewhere is referred to, not copied", "[recognition]") {
  std::mt19937 random(8);
  const SyntheticRoom room(1, 8, 8);
  IndexedBag map;
  Relocalizer relocalizer(map);
  static_assert(std::is_same_v<decltype(relocalizer), Relocalizer<IndexedBag&>>);
  CHECK(&relocalizer.map() == &map);
  CHECK_FALSE(relocalizer.localize(room.seen_from(random_camera(random))));
  map.add(KeyframeId{1}, room.seen_from(random_camera(random)));
  const auto query = room.seen_from(random_camera(random));
  CHECK(relocalizer.localize(query));
  RecognitionOptions strict;
  strict.decision.min_score = 1e9;
  const IndexedBag& only_read = map;
  const Relocalizer refusing(only_read, strict);
  static_assert(std::is_same_v<decltype(refusing), const Relocalizer<const IndexedBag&>>);
  CHECK_FALSE(refusing.localize(query));
  CHECK(refusing.localize(query, {}));
  const auto copy = relocalizer;  // of the reference
  CHECK(&copy.map() == &map);
}

TEST_CASE("the pose in the world is as uncertain as the match and the entry", "[recognition]") {
  std::mt19937 random(9);
  const SyntheticRoom room(1, 8, 8);
  const Eigen::Isometry3d T_world_candidate =
      Eigen::Translation3d(7, -2, 1) * Eigen::AngleAxisd(1.2, Eigen::Vector3d::UnitY());
  Relocalizer<> relocalizer;
  relocalizer.map().add(KeyframeId{1}, room.seen_from(random_camera(random)),
                        standing_at(T_world_candidate));
  const Recognition found = relocalizer.localize(room.seen_from(random_camera(random)));
  REQUIRE(found);
  const Eigen::Matrix<double, 6, 6> moved = adjoint(T_world_candidate) *
                                            found.accepted->pose->covariance *
                                            adjoint(T_world_candidate).transpose();
  const auto exact = relocalizer.T_world_query(found);
  REQUIRE(exact);
  CHECK(exact->covariance.isApprox(moved, 1e-9));
  const PoseWithCovariance<> entry{T_world_candidate,
                                   1e-3 * Eigen::Matrix<double, 6, 6>::Identity()};
  const auto uncertain = relocalizer.T_world_query(found, entry);
  REQUIRE(uncertain);
  CHECK(uncertain->T.matrix() == exact->T.matrix());
  CHECK(uncertain->covariance.isApprox(moved + entry.covariance, 1e-9));
  CHECK_FALSE(relocalizer.T_world_query({}, entry));
  PoseWithCovariance<> scaled = entry;
  scaled.T.linear() *= 3.0;
  CHECK(error_text([&] { relocalizer.T_world_query(found, scaled); }) ==
        "the candidate's pose is no rigid motion: it scales by 3.000000; divide the rotation by that");
}

TEST_CASE("an empty map and an empty query are answered with nothing", "[recognition]") {
  Relocalizer<> relocalizer;
  const TopologyGraph<> graph = SyntheticRoom(1, 8, 8).seen_from(Eigen::Isometry3d::Identity());
  const Recognition none = relocalizer.localize(graph);
  CHECK_FALSE(none);
  CHECK(none.usable);
  relocalizer.map().add(KeyframeId{1}, graph);
  CHECK_FALSE(relocalizer.localize(TopologyGraph<>{}).usable);
}

TEST_CASE("an indexed map gives the verdicts of a plain one with the same graphs",
          "[recognition][index]") {
  std::mt19937 random(7);
  Relocalizer<IndexedBag> indexed;
  Relocalizer<> plain;
  for (unsigned i = 0; i < 40; ++i) {
    const Eigen::Isometry3d T_room_camera = random_camera(random);
    EntryInfo info;  // the rooms stand 100 m apart
    info.T_world_camera = Eigen::Translation3d(100.0 * (i % 10), 0.0, 0.0) * T_room_camera;
    indexed.map().add(KeyframeId{i}, SyntheticRoom(i % 10, 8, 6).seen_from(T_room_camera), info);
    plain.map().add(KeyframeId{i}, *indexed.map().find(KeyframeId{i}), info);
  }
  RecognitionOptions few;
  few.retrieval.max_results = 6;
  for (unsigned i = 0; i < 10; ++i) {
    const auto query = SyntheticRoom(i, 8, 6).seen_from(random_camera(random));
    const Recognition a = indexed.localize(query, few), b = plain.localize(query, few);
    CAPTURE(i);
    REQUIRE(a);
    REQUIRE(b);
    CHECK(a.accepted->id == b.accepted->id);
    CHECK(a.accepted->margin() == b.accepted->margin());
    REQUIRE(a.candidates.size() == b.candidates.size());
    for (std::size_t k = 0; k < a.candidates.size(); ++k) {
      CHECK(a.candidates[k].id == b.candidates[k].id);
      CHECK(a.candidates[k].similarity == b.candidates[k].similarity);
    }
  }
}
