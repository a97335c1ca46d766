// SPDX-License-Identifier: MIT
#include <cstdint>
#include <limits>
#include <vector>

#include <topobag/bag/merge_options.hpp>
#include <topobag/graph/scaled_graph.hpp>

#include "bag/desk_pieces.hpp"
#include "bag/filled_bags.hpp"
#include "catch.hpp"

using namespace topobag;

TEST_CASE("bags merge, and say where each key frame went", "[bag][index]") {
  RecombinedGraphs source(desk_pieces(5), 5);
  IndexedBag bag = bag_of(source, 20), other = bag_of(source, 1);
  EntryInfo info;
  info.session = 2;
  info.T_world_camera = Eigen::Isometry3d::Identity();
  other.add(KeyframeId{900}, source.keyframe(source.place()), info);
  MergeOptions options;
  options.session_offset = 10;
  options.T_world_other = Eigen::Isometry3d(Eigen::Translation3d(1.0, 2.0, 3.0));
  const auto ids = bag.merge(*other.view(), options);
  CHECK(bag.size() == 211);
  REQUIRE(ids.size() == 11);
  for (std::uint64_t i = 0; i < 10; ++i) CHECK(ids.at(KeyframeId{i}) == KeyframeId{901 + i});
  CHECK(ids.at(KeyframeId{900}) == KeyframeId{900});
  for (const auto& [old_id, new_id] : ids) {
    CHECK(encode(*bag.find(new_id)) == encode(*other.find(old_id)));
  }
  CHECK(bag.info(KeyframeId{900})->session == 12);
  CHECK(bag.info(KeyframeId{901})->session == 10);
  CHECK(bag.info(KeyframeId{900})->T_world_camera->translation() == Eigen::Vector3d(1.0, 2.0, 3.0));
  const BruteForceBag oracle = brute_force_of(bag);
  for (int i = 0; i < 20; ++i) {
    const TopologyGraph<> query = source.keyframe(source.place());
    CHECK(bag.query(query) == oracle.query(query));
  }
  bag.add(KeyframeId{std::numeric_limits<std::uint64_t>::max()}, TopologyGraph<>{});
  CHECK_THROWS_AS(bag.merge(*bag.view()), InvalidValue);
  CHECK(bag.size() == 212);
}

TEST_CASE("a merged bag's cameras move with their map", "[bag][index]") {
  IndexedBag bag, other;
  EntryInfo info;
  info.T_world_camera = Eigen::Isometry3d(Eigen::Translation3d(1.0, 0.0, 0.0));
  other.add(KeyframeId{1}, TopologyGraph<>{}, info);
  MergeOptions options;
  Eigen::Isometry3d& T_world_other = options.T_world_other.emplace();
  T_world_other.setIdentity();
  T_world_other.linear() << 0, -1, 0, 1, 0, 0, 0, 0, 1;  // a quarter turn about z
  T_world_other.translation() = Eigen::Vector3d(10.0, 20.0, 30.0);
  bag.merge(*other.view(), options);
  const auto moved = bag.info(KeyframeId{1})->T_world_camera;
  CHECK(moved->translation().isApprox(Eigen::Vector3d(10.0, 21.0, 30.0)));
  CHECK(moved->linear().isApprox(T_world_other.linear()));
}

TEST_CASE("a bag without views stays so when another is merged", "[bag][index]") {
  const auto nodes = desk_pieces(9).front().nodes();
  const TopologyGraph<> seen(nodes, {}, std::vector<View<>>(3));
  IndexedBag bag({}, ViewSection::left_out), other, keeping;
  bag.add(KeyframeId{1}, seen);
  other.add(KeyframeId{2}, seen);
  bag.merge(*other.view());
  CHECK(encode(*bag.find(KeyframeId{2})) == encode(*bag.find(KeyframeId{1})));
  CHECK(bag.find(KeyframeId{2})->views().empty());
  CHECK(bag.query(seen) == brute_force_of(bag).query(seen));
  keeping.merge(*other.view());
  CHECK(keeping.find(KeyframeId{2})->views().size() == 3);
}

namespace {

/// That a bag takes in one of any kind as an indexed bag takes in one of its own.
template <typename Bag, typename Other>
void check_merge(const Other& other, const IndexedBag& same_as_other, RecombinedGraphs& source) {
  MergeOptions options;
  options.session_offset = 4;
  options.T_world_other = Eigen::Isometry3d(Eigen::Translation3d(1.0, 2.0, 3.0));
  Bag bag;
  IndexedBag oracle;
  for (std::uint64_t id = 5; id < 12; ++id) {
    const auto graph = source.keyframe(source.place());
    bag.add(KeyframeId{id}, decode(encode(graph)));
    oracle.add(KeyframeId{id}, graph);
  }
  CHECK(bag.merge(other, options) == oracle.merge(*same_as_other.view(), options));
  REQUIRE(bag.size() == oracle.size());
  oracle.for_each([&](KeyframeId id, const EntryInfo& info, const TopologyGraph<>& graph) {
    REQUIRE(bag.contains(id));
    CHECK(encode(*bag.find(id)) == encode(graph));
    CHECK(bag.info(id)->session == info.session);
    CHECK(bag.info(id)->T_world_camera.has_value() == info.T_world_camera.has_value());
  });
  CHECK(bag.places() == oracle.places());
  const auto query = source.keyframe(source.place());
  CHECK(bag.query(query) == oracle.query(query));
  // What is refused changes nothing.
  options.session_offset = std::numeric_limits<std::uint32_t>::max();
  bag.add(KeyframeId{1000}, {}, EntryInfo{std::nullopt, 1, std::nullopt, ""});
  CHECK_THROWS_AS(bag.merge(bag, options), InvalidId);
  CHECK(bag.size() == oracle.size() + 1);
}

}  // namespace

TEST_CASE("bags of every kind merge with each other", "[bag][index]") {
  RecombinedGraphs source(desk_pieces(6), 6);
  IndexedBag other = bag_of(source, 1);
  EntryInfo info;
  info.T_world_camera = Eigen::Isometry3d::Identity();
  other.add(KeyframeId{900}, source.keyframe(source.place()), info);
  BagOfTopologyGraphs<> plain;
  plain.merge(other);
  check_merge<BagOfTopologyGraphs<>>(other, other, source);
  check_merge<BagOfTopologyGraphs<>>(plain, other, source);
  check_merge<IndexedBag>(other, other, source);
  check_merge<IndexedBag>(plain, other, source);
}

namespace {

/// That a bag takes in one of another unit as it takes in the same map written in its own.
template <typename Bag, typename Other>
void check_merge_up_to_scale(RecombinedGraphs& source) {
  MergeOptions moved;
  moved.T_world_other = Eigen::Isometry3d(Eigen::Translation3d(1.0, 2.0, 3.0));
  MergeOptions with_scale = moved;
  with_scale.scale = 0.7;
  Other other;
  BagOfTopologyGraphs<> in_our_unit;  // does not round
  for (std::uint64_t id = 0; id < 8; ++id) {
    EntryInfo info;
    if (id % 2 == 0) {
      info.T_world_camera = Eigen::Isometry3d(Eigen::Translation3d(5.0 * double(id), -1.0, 0.5));
    }
    other.add(KeyframeId{id}, decode(encode(source.keyframe(source.place()))), info);
    if (info.T_world_camera) info.T_world_camera->translation() *= 0.7;
    in_our_unit.add(KeyframeId{id}, scaled(*other.find(KeyframeId{id}), 0.7), info);
  }
  Bag bag, oracle;
  CHECK(bag.merge(other, with_scale) == oracle.merge(in_our_unit, moved));
  REQUIRE(bag.size() == 8);
  oracle.for_each([&](KeyframeId id, const EntryInfo& info, const TopologyGraph<>& graph) {
    CHECK(encode(*bag.find(id)) == encode(graph));
    const auto pose = bag.info(id)->T_world_camera;
    REQUIRE(pose.has_value() == info.T_world_camera.has_value());
    if (pose) CHECK(pose->isApprox(*info.T_world_camera));
  });
  CHECK(bag.places() == oracle.places());
  const auto query = source.keyframe(source.place());
  CHECK(bag.query(query) == oracle.query(query));
  // A scale that is none changes nothing.
  for (const double scale : {0.0, -1.0, std::numeric_limits<double>::infinity(),
                             std::numeric_limits<double>::quiet_NaN()}) {
    with_scale.scale = scale;
    CHECK_THROWS_AS(bag.merge(other, with_scale), InvalidValue);
  }
  with_scale.scale = 1e9;  // beyond what a map keeps
  CHECK_THROWS_AS(bag.merge(other, with_scale), InvalidValue);
  CHECK(bag.size() == 8);
}

}  // namespace

TEST_CASE("a bag in another unit is taken in in the bag's own", "[bag][index]") {
  RecombinedGraphs source(desk_pieces(7), 7);
  check_merge_up_to_scale<BagOfTopologyGraphs<>, BagOfTopologyGraphs<>>(source);
  check_merge_up_to_scale<BagOfTopologyGraphs<>, IndexedBag>(source);
  check_merge_up_to_scale<IndexedBag, BagOfTopologyGraphs<>>(source);
  check_merge_up_to_scale<IndexedBag, IndexedBag>(source);
}
