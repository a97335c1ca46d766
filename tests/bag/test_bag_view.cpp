// SPDX-License-Identifier: MIT
#include <sstream>

#include <topobag/bag/bag_view.hpp>
#include <topobag/bag/detail/index/common_mass.hpp>
#include <topobag/bag/indexed_bag.hpp>
#include <topobag/bag/snapshot.hpp>

#include "bag/desk_pieces.hpp"
#include "bag/filled_bags.hpp"
#include "catch.hpp"
#include "recombined_graphs.hpp"

using namespace topobag;

namespace {

using Graph = TopologyGraph<>;

IndexedBag small_bag(RecombinedGraphs& source) {
  IndexedBag bag;
  for (std::uint64_t i = 0; i < 300; ++i) {
    EntryInfo info;
    info.stamp = static_cast<double>(i);
    info.label = i < 100 ? "a floor with a long name" : "";
    bag.add(KeyframeId{1000 - i}, source.keyframe(source.place()), info);
  }
  return bag;
}

}  // namespace

TEST_CASE("the quick way through an encoded graph finds what decoding finds", "[bag][index]") {
  std::mt19937 random(3);
  detail::NodeScan scan;
  const ClassPairDistanceHistogram similarity;
  for (int i = 0; i < 300; ++i) {
    const Graph graph = random_graph(random, static_cast<std::size_t>(i % 30), 1 + i % 90, false);
    auto bytes = encode(graph);
    const Graph decoded = decode<double>(bytes);
    bytes.insert(bytes.end(), detail::scan_margin, 0xFF);
    const auto& nodes = scan(bytes.data());
    REQUIRE(nodes.size() == decoded.size());
    for (std::size_t n = 0; n < nodes.size(); ++n) {
      CHECK(nodes[n].label == decoded.nodes()[n].label);
      CHECK(nodes[n].size == decoded.nodes()[n].size);
      CHECK(nodes[n].position == decoded.nodes()[n].position);
    }
    CHECK(similarity.descriptor_of(nodes) == similarity.descriptor(decoded));
  }
}

TEST_CASE("what two graphs have in common comes without the second's histogram", "[bag][index]") {
  RecombinedGraphs source(desk_pieces(8), 8);
  const ClassPairDistanceHistogram similarity;
  detail::NodeScan scan;
  for (int i = 0; i < 20; ++i) {
    const auto place = source.place();
    const Graph query = source.keyframe(place);
    std::vector<ClassId> labels;
    for (const auto& node : query.nodes()) labels.push_back(node.label);
    const SparseHistogram histogram = similarity.descriptor(query);
    detail::CommonMass common(similarity, histogram, labels);
    for (int k = 0; k < 50; ++k) {
      const Graph graph = source.keyframe(k % 2 == 0 ? place : source.place());
      auto bytes = encode(graph);
      bytes.insert(bytes.end(), detail::scan_margin, 0);
      const SparseHistogram stored =
          similarity.descriptor(decode<double>(bytes.data(), bytes.size() - detail::scan_margin));
      const double expected = detail::sum_over_common(
          histogram, stored, [](double x, double y) { return std::min(x, y); });
      CHECK(common(scan(bytes.data())) == Approx(expected).margin(1e-12));
    }
  }
}

TEST_CASE("a saved and loaded bag answers as the first one", "[bag][index]") {
  RecombinedGraphs source(desk_pieces(9), 9);
  const IndexedBag bag = small_bag(source);
  std::stringstream stream;
  save(*bag.view(), stream);
  const auto loaded = load<IndexedBag>(stream);
  REQUIRE(loaded.size() == 300);
  for (int i = 0; i < 20; ++i) {
    const Graph query = source.keyframe(source.place());
    CHECK(loaded.query(query) == bag.query(query));
  }
  CHECK(loaded.info(KeyframeId{950})->label == "a floor with a long name");
}

TEST_CASE("a view and a copy stay as they were", "[bag][index]") {
  RecombinedGraphs source(desk_pieces(4), 4);
  IndexedBag bag = bag_of(source, 20);
  const Graph query = source.keyframe(source.place());
  const auto view = bag.view();
  const auto before = view->query(query);
  IndexedBag copy = bag;
  for (std::uint64_t i = 0; i < 150; ++i) CHECK(bag.erase(KeyframeId{i}));
  for (std::uint64_t i = 150; i < 170; ++i) bag.update(KeyframeId{i}, query);
  for (std::uint64_t i = 1000; i < 1200; ++i) bag.add(KeyframeId{i}, query);
  copy.add(KeyframeId{5000}, Graph{});
  bag.add(KeyframeId{5000}, query);
  CHECK(view->query(query) == before);
  CHECK(view->size() == 200);
  CHECK(copy.size() == 201);
  CHECK(copy.find(KeyframeId{5000})->empty());
  CHECK(bag.size() == 251);
  CHECK(copy.query(query) == before);
  copy = bag;
  CHECK(copy.query(query) == bag.query(query));
  bag.clear();
  CHECK(bag.empty());
  CHECK(copy.size() == 251);
}
