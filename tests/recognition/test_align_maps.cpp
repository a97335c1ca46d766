// SPDX-License-Identifier: MIT
#include <topobag/recognition/align_maps.hpp>

#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include <topobag/bag/bag_of_topology_graphs.hpp>
#include <topobag/bag/indexed_bag.hpp>

#include "catch.hpp"
#include "synthetic_room.hpp"

using namespace topobag;

namespace {

/// Rooms 8 m apart, by their seeds, each seen by three cameras; the map's world lies at
/// `T_map_building`.
template <typename Bag = BagOfTopologyGraphs<>>
Bag map_of_rooms(const std::vector<unsigned>& seeds, const Eigen::Isometry3d& T_map_building,
                 std::mt19937& random) {
  Bag bag;
  std::uint64_t id = 0;
  for (std::size_t i = 0; i < seeds.size(); ++i) {
    const Eigen::Translation3d T_building_room(8.0 * static_cast<double>(i), 0.0, 0.0);
    for (int camera = 0; camera < 3; ++camera) {
      const Eigen::Isometry3d T_room_camera = random_camera(random);
      bag.add(KeyframeId{id++}, SyntheticRoom(seeds[i], 9, 6).seen_from(T_room_camera),
              standing_at(T_map_building * T_building_room * T_room_camera));
    }
  }
  return bag;
}

Eigen::Isometry3d between_worlds() {
  return Eigen::Translation3d(5.0, -3.0, 0.4) *
         Eigen::AngleAxisd(0.9, Eigen::Vector3d(0.1, 1.0, 0.0).normalized());
}

}  // namespace

TEST_CASE("two maps of one building are laid over each other", "[recognition]") {
  std::mt19937 random(1);
  const auto a = map_of_rooms({1, 2, 3, 4}, Eigen::Isometry3d::Identity(), random);
  const auto b = map_of_rooms<IndexedBag>({1, 2, 3, 4}, between_worlds().inverse(), random);
  const MapAlignment alignment = align_maps(a, b);
  REQUIRE(alignment);
  CHECK(alignment.verdict == AlignmentVerdict::aligned);
  CHECK(alignment.asked == 12);
  CHECK(alignment.agreeing >= 9);
  CHECK(alignment.places >= 4);
  CHECK(alignment.T_a_b->T.isApprox(between_worlds(), 1e-2));
  // The other way round it is the inverse.
  const MapAlignment back = align_maps(b, a);
  REQUIRE(back);
  CHECK((back.T_a_b->T * alignment.T_a_b->T).isApprox(Eigen::Isometry3d::Identity(), 2e-2));
}

TEST_CASE("maps of look-alike buildings are not joined", "[recognition]") {
  std::mt19937 random(3);
  // Two wings with the same rooms: each of map b's fits both.
  const auto a = map_of_rooms({1, 2, 9, 1, 2}, Eigen::Isometry3d::Identity(), random);
  const auto b = map_of_rooms({1, 2}, between_worlds().inverse(), random);
  const MapAlignment two = align_maps(a, b);
  CHECK_FALSE(two);
  CHECK(two.verdict == AlignmentVerdict::ambiguous);
  CHECK(two.rivalling >= 3);
  // The room between the wings tells which is which.
  const auto with_middle = map_of_rooms({1, 2, 9}, between_worlds().inverse(), random);
  AlignOptions options;
  options.max_rival_share = 0.8;
  const MapAlignment one = align_maps(a, with_middle, options);
  REQUIRE(one);
  CHECK(one.T_a_b->T.isApprox(between_worlds(), 1e-2));
}

TEST_CASE("two maps that are alike in one room of many are not joined by it", "[recognition]") {
  // Cameras stand alike in both: by the one room, each of b's would see what one of a's saw.
  std::vector<unsigned> seeds_a, seeds_b;
  for (unsigned room = 0; room < 12; ++room) {
    seeds_a.push_back(100 + room);
    seeds_b.push_back(room == 5 ? seeds_a.back() : 200 + room);
  }
  std::mt19937 random(6), same(6);
  const auto a = map_of_rooms(seeds_a, Eigen::Isometry3d::Identity(), random);
  const auto b = map_of_rooms(seeds_b, between_worlds().inverse(), same);
  const MapAlignment alignment = align_maps(a, b);
  CHECK_FALSE(alignment);
  CHECK(alignment.verdict == AlignmentVerdict::contradicted);
  CHECK(alignment.agreeing == 3);
  CHECK(alignment.revisiting == 36);
  AlignOptions trusting;
  trusting.min_revisit_share = 0.0;
  CHECK(align_maps(a, b, trusting));
  // A map of that room alone has nothing that contradicts it.
  std::mt19937 alone(7);
  const auto room = map_of_rooms({seeds_a[5]}, between_worlds().inverse(), alone);
  CHECK(align_maps(a, room));
}

TEST_CASE("maps of different buildings and maps without poses are told apart", "[recognition]") {
  std::mt19937 random(4);
  const auto a = map_of_rooms({1, 2, 3}, Eigen::Isometry3d::Identity(), random);
  const auto elsewhere = map_of_rooms({11, 12, 13}, Eigen::Isometry3d::Identity(), random);
  const MapAlignment none = align_maps(a, elsewhere);
  CHECK_FALSE(none);
  CHECK(none.verdict == AlignmentVerdict::too_few);
  BagOfTopologyGraphs<> unposed;
  unposed.add(KeyframeId{1}, SyntheticRoom(1, 9, 6).seen_from(random_camera(random)));
  for (const auto& alignment : {align_maps(a, unposed), align_maps(unposed, a)}) {
    CHECK(alignment.verdict == AlignmentVerdict::no_poses);
    CHECK(alignment.asked == 0);
  }
  CHECK(why(none.verdict) != std::string(why(AlignmentVerdict::no_poses)));
}

TEST_CASE("only so many key frames are asked, from all over the map", "[recognition]") {
  std::mt19937 random(5);
  const auto a = map_of_rooms({1, 2, 3, 4}, Eigen::Isometry3d::Identity(), random);
  AlignOptions options;
  options.max_keyframes = 4;
  std::size_t told = 0;
  options.on_query = [&] { ++told; };
  const MapAlignment alignment = align_maps(a, a, options);
  REQUIRE(alignment);
  CHECK(alignment.asked == 4);
  CHECK(told == 4);
  CHECK(alignment.places >= 4);
}
