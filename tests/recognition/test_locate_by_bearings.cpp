// SPDX-License-Identifier: MIT
#include <cstddef>
#include <random>

#include <Eigen/Geometry>

#include <topobag/bag/bag_of_topology_graphs.hpp>
#include <topobag/bag/indexed_bag.hpp>
#include <topobag/recognition/locate_by_bearings.hpp>

#include "catch.hpp"
#include "recognition/bearings_of.hpp"
#include "recognition/synthetic_room.hpp"

using namespace topobag;

namespace {

/// Where the n-th room of a row stands.
Eigen::Isometry3d room_by_bearings(unsigned n) {
  return Eigen::Isometry3d(Eigen::Translation3d(20.0 * n, 0.0, 0.0));
}

/// Four key frames of each room, with every pose.
template <typename Bag>
void map_rooms(Bag& bag, unsigned rooms, std::mt19937& random) {
  for (unsigned i = 0; i < 4 * rooms; ++i) {
    const Eigen::Isometry3d T_room_camera = random_camera(random);
    bag.add(KeyframeId{i}, SyntheticRoom(i / 4, 9, 8).seen_from(T_room_camera),
            standing_at(room_by_bearings(i / 4) * T_room_camera));
  }
}

}  // namespace

TEST_CASE("a camera without depth is found in the room where it is", "[locate_by_bearings]") {
  std::mt19937 random(11);
  BagOfTopologyGraphs<> map;
  map_rooms(map, 5, random);
  std::size_t found = 0;
  for (unsigned i = 0; i < 20; ++i) {
    const Eigen::Isometry3d T_room_camera = random_camera(random);
    const auto seen = SyntheticRoom(i % 5, 9, 8).seen_from(T_room_camera);
    const Recognition recognition = locate_by_bearings(map, bearings_of(seen, random, 0.005));
    CHECK(recognition.usable);
    if (!recognition) continue;
    const CandidateReport& accepted = *recognition.accepted;
    const Eigen::Isometry3d T_world_camera =
        *map.info(accepted.id)->T_world_camera * accepted.pose->T_candidate_query;
    const Eigen::Isometry3d truth = room_by_bearings(i % 5) * T_room_camera;
    INFO("query " << i);
    CHECK((T_world_camera.translation() - truth.translation()).norm() < 0.3);
    CHECK(accepted.score() >= accepted.threshold);
    CHECK(accepted.verdict == Verdict::accepted);
    ++found;
  }
  CHECK(found >= 18);
}

TEST_CASE("a camera without depth in a room that was never mapped is not found",
          "[locate_by_bearings]") {
  std::mt19937 random(12);
  BagOfTopologyGraphs<> map;
  map_rooms(map, 5, random);
  std::size_t found = 0;
  for (unsigned i = 0; i < 40; ++i) {
    const auto seen = SyntheticRoom(100 + i, 9, 8).seen_from(random_camera(random));
    if (locate_by_bearings(map, bearings_of(seen, random, 0.005))) ++found;
  }
  CHECK(found == 0);
}

TEST_CASE("two equal rooms keep bearings from an answer", "[locate_by_bearings]") {
  std::mt19937 random(13);
  BagOfTopologyGraphs<> map;
  for (unsigned i = 0; i < 2; ++i) {
    const Eigen::Isometry3d T_room_camera = random_camera(random);
    map.add(KeyframeId{i}, SyntheticRoom(3, 9, 8).seen_from(T_room_camera),
            standing_at(room_by_bearings(i) * T_room_camera));
  }
  const auto seen = SyntheticRoom(3, 9, 8).seen_from(random_camera(random));
  const Recognition recognition = locate_by_bearings(map, bearings_of(seen, random, 0.005));
  CHECK_FALSE(recognition);
  REQUIRE_FALSE(recognition.candidates.empty());
  const CandidateReport& best = recognition.candidates.front();
  CHECK(best.verdict == Verdict::rivalled);
  REQUIRE(best.rival);
  CHECK(best.rival->id != best.id);
  REQUIRE(best.rival->T_world_query);  // in the other room, where the camera is in this one
  const auto in_room = [&](KeyframeId id, const Eigen::Isometry3d& T_world_camera) {
    return Eigen::Vector3d(
        (room_by_bearings(static_cast<unsigned>(value(id))).inverse() * T_world_camera)
            .translation());
  };
  const Eigen::Isometry3d own = *map.info(best.id)->T_world_camera * best.pose->T_candidate_query;
  CHECK((in_room(best.rival->id, *best.rival->T_world_query) - in_room(best.id, own)).norm() < 0.5);
}

TEST_CASE("every bag that can be walked through can be asked by bearings", "[locate_by_bearings]") {
  std::mt19937 random(14);
  IndexedBag indexed;
  BagOfTopologyGraphs<> plain;
  for (unsigned i = 0; i < 4; ++i) {
    const Eigen::Isometry3d T_room_camera = random_camera(random);
    const auto graph = SyntheticRoom(0, 9, 8).seen_from(T_room_camera);
    indexed.add(KeyframeId{i}, graph, standing_at(T_room_camera));
    plain.add(KeyframeId{i}, graph, standing_at(T_room_camera));
  }
  const auto seen = SyntheticRoom(0, 9, 8).seen_from(random_camera(random));
  const BearingSighting query = bearings_of(seen, random, 0.005);
  const Recognition a = locate_by_bearings(plain, query), b = locate_by_bearings(indexed, query);
  REQUIRE(a);
  REQUIRE(b);
  CHECK(a.accepted->id == b.accepted->id);
  BearingSighting three = query;
  three.bearings.resize(3);
  CHECK_FALSE(locate_by_bearings(plain, three).usable);
  RecognitionOptions options;
  options.retrieval.filter = [](KeyframeId, const EntryInfo&) { return false; };
  CHECK(locate_by_bearings(plain, query, options).candidates.empty());
}
