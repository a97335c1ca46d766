// SPDX-License-Identifier: MIT
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

#include <topobag/bag/detail/codec/node_scan.hpp>
#include <topobag/bag/graph_codec.hpp>
#include <topobag/bag/indexed_bag.hpp>

#include "bag/realistic_graphs.hpp"
#include "catch.hpp"
#include "error_text.hpp"
#include "random_appearance.hpp"
#include "random_label_weights.hpp"

using namespace topobag;

TEST_CASE("label weights come back from a graph's bytes as they were", "[bag][codec]") {
  std::mt19937 random(1);
  for (int trial = 0; trial < 300; ++trial) {
    TopologyGraph<> plain = realistic_graph(random, 1 + random() % 30, trial % 2 == 0);
    if (trial % 3 == 0) plain = with_appearance(random, plain, AppearanceKind("short", 8));
    const TopologyGraph<> graph = with_label_weights(random, plain);
    CHECK(codec_version_for(graph) == 2);
    const auto bytes = encode(graph);
    const TopologyGraph<> back = decode(bytes);
    REQUIRE(back.size() == graph.size());
    auto bare = back.nodes();
    for (std::size_t i = 0; i < graph.size(); ++i) {
      CHECK(back.nodes()[i].label == graph.nodes()[i].label);
      CHECK(back.nodes()[i].label_weights == graph.nodes()[i].label_weights);
      bare[i].label_weights = {};
    }
    CHECK(encode(back) == bytes);
    CHECK(encode(TopologyGraph<>(bare, back.edges(), back.views())) == encode(plain));
    // What retrieval reads is the same.
    std::vector<std::uint8_t> padded = bytes;
    padded.insert(padded.end(), detail::scan_margin, 0);
    CHECK(detail::node_count(padded.data()) == graph.size());
    detail::NodeScan scan;
    const auto& scanned = scan(padded.data());
    for (std::size_t i = 0; i < graph.size(); ++i) {
      CHECK(scanned[i].label == graph.nodes()[i].label);
      CHECK(scanned[i].position.has_value() == graph.nodes()[i].position.has_value());
    }
  }
}

TEST_CASE("a bag keeps label weights", "[bag][index]") {
  std::mt19937 random(2);
  const TopologyGraph<> graph = with_label_weights(random, realistic_graph(random, 9));
  IndexedBag bag;
  bag.add(KeyframeId{3}, graph);
  const auto kept = bag.find(KeyframeId{3});
  REQUIRE(kept);
  for (std::size_t i = 0; i < graph.size(); ++i) {
    CHECK(kept->nodes()[i].label_weights == graph.nodes()[i].label_weights);
  }
}

TEST_CASE("damaged label weights are refused or mean something, whatever the bytes",
          "[bag][codec]") {
  std::mt19937 random(3);
  std::size_t refused = 0;
  for (int trial = 0; trial < 3000; ++trial) {
    const TopologyGraph<> graph =
        with_label_weights(random, realistic_graph(random, 1 + random() % 6, false));
    std::vector<std::uint8_t> bytes = encode(graph);
    bytes[random() % bytes.size()] ^= static_cast<std::uint8_t>(1U << (random() % 8));
    if (trial % 5 == 0) bytes.resize(random() % bytes.size());
    try {
      const TopologyGraph<> read = decode(bytes);
      CHECK(encode(decode(encode(read))) == encode(read));
    } catch (const Error&) {
      ++refused;
    }
  }
  CHECK(refused > 600);
}

TEST_CASE("version 1 knows no label weights", "[bag][codec]") {
  std::vector<SemanticNode<>> nodes(1);
  nodes[0].label_weights = LabelWeights({{ClassId{0}, 1.0}, {ClassId{1}, 0.5}});
  detail::BitWriter writer;
  detail::put_header(writer, {});
  detail::NodeColumns(nodes).put(writer);
  CHECK(error_text([&] { decode(writer.take()); }) ==
        "a graph of version 1 with label weights: the data are damaged");
}

TEST_CASE("weights whose best is another class than the label make no graph", "[bag]") {
  std::vector<SemanticNode<>> nodes(2);
  nodes[1].label = ClassId{1};
  nodes[1].label_weights = LabelWeights({{ClassId{0}, 1.0}, {ClassId{1}, 0.5}});
  CHECK(error_text([&] { TopologyGraph<> graph(nodes); }) ==
        "node 1 has label weights whose best is not its label");
}
