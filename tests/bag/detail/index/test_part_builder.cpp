// SPDX-License-Identifier: MIT
#include <topobag/bag/detail/index/part_builder.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include <topobag/bag/graph_codec.hpp>
#include <topobag/similarity/class_pair_distance_histogram.hpp>

#include "catch.hpp"

using namespace topobag;

namespace {

using EmptyGraphs = detail::PartBuilder<ClassPairDistanceHistogram>;

/// Parts of so many graphs without a node each.
std::vector<detail::SealedPart> parts_of_sizes(const std::vector<std::size_t>& sizes) {
  const ClassPairDistanceHistogram similarity;
  std::vector<std::uint8_t> bytes = encode(TopologyGraph<>{});
  const std::size_t size = bytes.size();
  bytes.insert(bytes.end(), detail::scan_margin, 0);
  std::uint64_t id = 0;
  std::vector<detail::SealedPart> parts;
  for (const std::size_t count : sizes) {
    EmptyGraphs builder(similarity);
    for (std::size_t i = 0; i < count; ++i) builder.add(KeyframeId{id++}, {}, bytes.data(), size);
    for (detail::SealedPart& part : builder.finish()) parts.push_back(std::move(part));
  }
  return parts;
}

std::size_t ripe(const std::vector<std::size_t>& sizes) {
  return detail::ripe_for_merge(parts_of_sizes(sizes));
}

}  // namespace

TEST_CASE("four parts of about one size are ripe, and no much larger one with them", "[bag]") {
  CHECK(ripe({}) == 0);
  CHECK(ripe({2, 2, 2}) == 0);
  CHECK(ripe({2, 2, 2, 2}) == 4);
  CHECK(ripe({7, 5, 3, 2}) == 4);
  CHECK(ripe({8, 2, 2, 2}) == 0);  // four times as large as the last
  CHECK(ripe({8, 2, 2, 2, 2}) == 4);
  CHECK(ripe({2, 2, 2, 2, 2}) == 5);
}

TEST_CASE("a part holds no more graphs than its index can number", "[bag]") {
  const auto parts = parts_of_sizes({detail::max_segment_size + 1});
  REQUIRE(parts.size() == 2);
  CHECK(parts[0].segment->size() == detail::max_segment_size);
  CHECK(parts[1].segment->size() == 1);
}
