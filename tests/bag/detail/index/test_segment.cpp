// SPDX-License-Identifier: MIT
#include <topobag/bag/detail/index/segment.hpp>

#include <cstdint>
#include <random>
#include <vector>

#include <topobag/bag/graph_codec.hpp>
#include <topobag/similarity/class_pair_distance_histogram.hpp>

#include "catch.hpp"
#include "random_graphs.hpp"

using namespace topobag;

namespace {

using SegmentBuilder = detail::Segment::Builder<ClassPairDistanceHistogram>;

void add_encoded(SegmentBuilder& builder, std::uint64_t id, const TopologyGraph<>& graph) {
  std::vector<std::uint8_t> bytes = encode(graph);
  const std::size_t size = bytes.size();
  bytes.insert(bytes.end(), detail::scan_margin, 0);
  builder.add(KeyframeId{id}, {}, bytes.data(), size);
}

}  // namespace

TEST_CASE("alike graphs share a leaf, strangers do not", "[bag]") {
  std::mt19937 random(12);
  const ClassPairDistanceHistogram similarity;
  const TopologyGraph<> one = random_graph(random, 8, 2, false);
  std::vector<SemanticNode<>> nodes = one.nodes();
  for (auto& node : nodes) node.label = ClassId{value(node.label) + 100};
  const TopologyGraph<> stranger(nodes);

  SegmentBuilder alike(similarity), mixed(similarity);
  const std::size_t most = detail::Segment::max_leaf_size;
  for (std::size_t i = 0; i < 2 * most + 1; ++i) {
    add_encoded(alike, i, one);
    add_encoded(mixed, i, i % 2 == 0 ? one : stranger);
  }
  const detail::Segment segment = alike.build();
  REQUIRE(segment.leaves() == 3);
  for (std::size_t leaf = 0; leaf < 3; ++leaf) {
    CHECK(segment.leaf_begin(leaf) == leaf * most);
    CHECK(segment.leaf_end(leaf) == (leaf < 2 ? (leaf + 1) * most : 2 * most + 1));
  }
  CHECK(mixed.build().leaves() == 2 * most + 1);
}

TEST_CASE("an entry is found by its id in whatever order they came", "[bag]") {
  std::mt19937 random(13);
  const ClassPairDistanceHistogram similarity;
  SegmentBuilder builder(similarity);
  const std::vector<std::uint64_t> ids{40, 7, 19, 2, 31};
  for (const std::uint64_t id : ids) add_encoded(builder, id, random_graph(random, 4, 2, false));
  const detail::Segment segment = builder.build();
  for (std::size_t slot = 0; slot < ids.size(); ++slot) {
    CHECK(segment.slot_of(KeyframeId{ids[slot]}) == slot);
    CHECK_FALSE(segment.slot_of(KeyframeId{ids[slot] + 1}));
  }
}
