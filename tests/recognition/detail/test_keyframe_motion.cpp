// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include <topobag/bag/bag_of_topology_graphs.hpp>
#include <topobag/bag/indexed_bag.hpp>
#include <topobag/recognition/detail/keyframe_motion.hpp>

#include "catch.hpp"
#include "recognition/synthetic_room.hpp"

using namespace topobag;

namespace {

/// A camera that goes round a room, 0.1 m and 5 degrees a key frame.
Eigen::Isometry3d on_its_way(std::uint64_t step) {
  const double at = static_cast<double>(step);
  return Eigen::Translation3d(0.1 * at, 0.2 * std::sin(0.3 * at), 0.0) *
         Eigen::AngleAxisd(0.09 * at, Eigen::Vector3d::UnitY());
}

/// Key frames of a room without poses, every `stride`-th number.
template <typename Bag>
Bag filmed_room(std::uint64_t count, std::uint64_t stride, std::uint32_t session = 0) {
  Bag bag;
  const SyntheticRoom room(4, 10, 10);
  EntryInfo info;
  info.session = session;
  for (std::uint64_t i = 0; i < count; ++i) {
    bag.add(KeyframeId{stride * i}, room.seen_from(on_its_way(i)), info);
  }
  return bag;
}

template <typename Bag>
std::optional<Eigen::Isometry3d> between(const Bag& bag, std::uint64_t a, std::uint64_t b,
                                         const RecognitionOptions& options = {}) {
  const auto of_a = bag.info(KeyframeId{a}), of_b = bag.info(KeyframeId{b});
  detail::KeyframeMotion<Bag> motion(bag, options);
  return motion.between({KeyframeId{a}, of_a}, {KeyframeId{b}, of_b});
}

}  // namespace

TEST_CASE("where key frames stand is followed by the map's own objects", "[recognition]") {
  const std::uint64_t count = 30;
  const RecognitionOptions options;
  for (const std::uint64_t stride : {1U, 17U}) {
    const auto bag = filmed_room<BagOfTopologyGraphs<>>(count, stride);
    detail::KeyframeMotion<BagOfTopologyGraphs<>> motion(bag, options);
    const auto info = bag.info(KeyframeId{0});
    for (std::uint64_t a = 0; a < count; a += 3) {
      for (std::uint64_t b = 0; b < count; b += 2) {
        const auto T_a_b =
            motion.between({KeyframeId{stride * a}, info}, {KeyframeId{stride * b}, info});
        REQUIRE(T_a_b);
        CHECK(T_a_b->isApprox(on_its_way(a).inverse() * on_its_way(b), 1e-3));
      }
    }
  }
  const auto indexed = filmed_room<IndexedBag>(count, 5);
  const auto T_first_last = between(*indexed.view(), 0, 5 * (count - 1));
  REQUIRE(T_first_last);  // off by what the codec rounds
  CHECK(T_first_last->isApprox(on_its_way(0).inverse() * on_its_way(count - 1), 0.05));
}

TEST_CASE("poses in the world tell it at once", "[recognition]") {
  BagOfTopologyGraphs<> bag;
  const Eigen::Isometry3d a = on_its_way(3), b = on_its_way(40);
  bag.add(KeyframeId{1}, {}, standing_at(a));
  bag.add(KeyframeId{2}, {}, standing_at(b, 1));
  bag.add(KeyframeId{3}, {});
  const auto T_a_b = between(bag, 1, 2);
  REQUIRE(T_a_b);
  CHECK(T_a_b->isApprox(a.inverse() * b, 1e-12));
  CHECK_FALSE(between(bag, 1, 3));
}

TEST_CASE("what looks alike elsewhere is not taken for a way there", "[recognition]") {
  // The same film again after key frames of other rooms, which nothing leads through.
  auto bag = filmed_room<BagOfTopologyGraphs<>>(5, 1);
  for (std::uint64_t i = 5; i < 10; ++i) {
    bag.add(KeyframeId{i}, SyntheticRoom(50 + static_cast<unsigned>(i), 9, 5)
                               .seen_from(Eigen::Isometry3d::Identity()));
  }
  const auto again = filmed_room<BagOfTopologyGraphs<>>(5, 1);
  again.for_each([&](KeyframeId id, const EntryInfo& info, const TopologyGraph<>& graph) {
    bag.add(KeyframeId{10 + value(id)}, graph, info);
  });
  CHECK(between(bag, 1, 4));
  CHECK(between(bag, 11, 14));
  CHECK_FALSE(between(bag, 1, 11));
  CHECK_FALSE(between(bag, 11, 1));
}

TEST_CASE("one key frame that shows too little may be left out on the way", "[recognition]") {
  auto bag = filmed_room<BagOfTopologyGraphs<>>(20, 1);
  bag.update(KeyframeId{10}, {});
  const auto T_a_b = between(bag, 2, 18);
  REQUIRE(T_a_b);
  CHECK(T_a_b->isApprox(on_its_way(2).inverse() * on_its_way(18), 1e-3));
  CHECK_FALSE(between(bag, 2, 10));
}

TEST_CASE("another session stands nowhere, and a query follows no further than it may",
          "[recognition]") {
  auto bag = filmed_room<BagOfTopologyGraphs<>>(20, 2);
  EntryInfo other;
  other.session = 1;
  bag.add(KeyframeId{5}, *bag.find(KeyframeId{4}), other);
  CHECK_FALSE(between(bag, 4, 5));
  CHECK(between(bag, 4, 6));  // past it

  RecognitionOptions options;
  options.place.max_followed = 7;
  CHECK(between(bag, 0, 14, options));
  CHECK_FALSE(between(bag, 0, 16, options));
}
