// SPDX-License-Identifier: MIT
#include <cstddef>
#include <cstdint>
#include <random>
#include <sstream>
#include <vector>

#include <topobag/bag/detail/codec/node_scan.hpp>
#include <topobag/bag/graph_codec.hpp>
#include <topobag/bag/indexed_bag.hpp>
#include <topobag/bag/snapshot.hpp>

#include "bag/realistic_graphs.hpp"
#include "bag/saved_bags.hpp"
#include "catch.hpp"
#include "error_text.hpp"
#include "random_appearance.hpp"

using namespace topobag;

namespace {

const AppearanceKind short_kind("short", 8);

TopologyGraph<> described_graph(std::mt19937& random, std::size_t count) {
  return with_appearance(random, realistic_graph(random, count), short_kind);
}

}  // namespace

TEST_CASE("appearance comes back from a graph's bytes as it was", "[bag][codec][appearance]") {
  std::mt19937 random(1);
  for (int trial = 0; trial < 300; ++trial) {
    const TopologyGraph<> plain = realistic_graph(random, 1 + random() % 30, trial % 2 == 0);
    const AppearanceKind kind("random", 1 + random() % AppearanceKind::max_length);
    TopologyGraph<> graph = with_appearance(random, plain, kind);
    if (trial % 3 == 0) {
      graph = TopologyGraph<>(graph.nodes(), graph.edges(), graph.views(), Gravity<>{});
    }
    const auto bytes = encode(graph);
    CHECK(codec_version_for(graph) == 2);
    const TopologyGraph<> back = decode(bytes);
    CHECK(back.appearance_kind() == kind);
    CHECK(back.gravity().has_value() == graph.gravity().has_value());
    REQUIRE(back.size() == graph.size());
    std::vector<SemanticNode<>> bare = back.nodes();
    std::size_t known = 0;
    for (std::size_t i = 0; i < graph.size(); ++i) {
      CHECK(back.nodes()[i].appearance == graph.nodes()[i].appearance);
      known += graph.nodes()[i].appearance.known() ? 1U : 0U;
      bare[i].appearance = {};
    }
    CHECK(encode(TopologyGraph<>(bare, back.edges(), back.views())) == encode(plain));
    CHECK(encode(back) == bytes);
    // 2 bits of the header, 5 of gravity, the kind, and a bit a node.
    const std::size_t without = encode(plain).size() + (graph.gravity() ? 5 : 0);
    CHECK(bytes.size() <= without + 1 + (38 + graph.size()) / 8 + 1 + known * kind.length());
  }
}

TEST_CASE("a graph without appearance is written as before there was any",
          "[bag][codec][appearance]") {
  std::mt19937 random(2);
  const TopologyGraph<> plain = realistic_graph(random, 12);
  CHECK(codec_version_for(plain) == 1);
  CHECK((encode(plain)[0] & 15) == 1);
}

TEST_CASE("the bytes of an appearance", "[bag][codec][appearance]") {
  SemanticNode<> node;
  node.appearance = Appearance(AppearanceKind("a", 2), Appearance::Bytes{-1, 5});
  const auto bytes = encode(TopologyGraph<>({node, {}}));
  detail::BitWriter writer;
  detail::put_header(writer, {2, false, false, true});
  detail::NodeColumns(std::vector<SemanticNode<>>(2)).put(writer);
  detail::put_edges(writer, {}, 2);
  writer.put(0xe40c292c, 32);  // FNV-1a of "a"
  writer.put(1, 6);            // the length less one
  writer.put(1, 1);
  writer.put(0xFF, 8);
  writer.put(5, 8);
  writer.put(0, 1);
  CHECK(bytes == writer.take());
}

TEST_CASE("appearance that says nothing is damaged", "[bag][codec][appearance]") {
  const auto said = [](const std::vector<std::uint64_t>& bytes_of_nodes) {
    detail::BitWriter writer;
    detail::put_header(writer, {2, false, false, true});
    const std::vector<SemanticNode<>> nodes(bytes_of_nodes.size());
    detail::NodeColumns(nodes).put(writer);
    detail::put_edges(writer, {}, nodes.size());
    writer.put(1, 32);
    writer.put(0, 6);
    for (const std::uint64_t byte : bytes_of_nodes) {
      writer.put(byte < 256 ? 1 : 0, 1);
      if (byte < 256) writer.put(byte, 8);
    }
    return error_text([&] { decode(writer.take()); });
  };
  CHECK(said({256, 7}) == "nothing was thrown");
  CHECK(said({7, 0}) == "the data hold a descriptor of zeros: they are damaged");
  CHECK(said({256, 256}) == "the data name a kind of appearance and hold none: they are damaged");
  CHECK(said({}) == "the data name a kind of appearance and hold none: they are damaged");
}

TEST_CASE("a graph with appearance is refused wherever it is cut off", "[bag][codec][appearance]") {
  std::mt19937 random(3);
  const auto good = encode(described_graph(random, 8));
  for (std::size_t size = 0; size < good.size(); ++size) {
    CHECK_THROWS_AS(decode(good.data(), size), FormatError);
  }
  for (std::size_t bit = 0; bit < 8 * good.size(); ++bit) {
    auto flipped = good;
    flipped[bit / 8] = static_cast<std::uint8_t>(flipped[bit / 8] ^ 1U << bit % 8);
    try {
      const auto once = encode(decode(flipped));
      CHECK(encode(decode(once)) == once);
    } catch (const FormatError&) {
    }
  }
}

TEST_CASE("the scan of the nodes passes appearance over", "[bag][codec][appearance]") {
  std::mt19937 random(4);
  detail::NodeScan scan_plain, scan;
  for (int trial = 0; trial < 100; ++trial) {
    const TopologyGraph<> plain = realistic_graph(random, 1 + random() % 30);
    auto without = encode(plain), with = encode(with_appearance(random, plain, short_kind));
    for (auto* bytes : {&without, &with}) bytes->insert(bytes->end(), detail::scan_margin, 0);
    const auto& expected = scan_plain(without.data());
    const auto& nodes = scan(with.data());
    REQUIRE(nodes.size() == expected.size());
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      CHECK(nodes[i].label == expected[i].label);
      CHECK(nodes[i].position == expected[i].position);
    }
  }
}

TEST_CASE("a saved bag keeps appearance and says its version", "[bag][snapshot][appearance]") {
  std::mt19937 random(5);
  BagOfTopologyGraphs<> bag = random_bag(random, 4);
  const TopologyGraph<> described = described_graph(random, 5);
  bag.add(KeyframeId{77}, described);
  const std::string bytes = saved(bag);
  std::istringstream stream(bytes);
  CHECK(inspect(stream).codec_version == 2);
  const BagOfTopologyGraphs<> back = loaded(bytes);
  CHECK(saved(back) == bytes);
  CHECK(back.appearance_kind() == short_kind);
}

TEMPLATE_TEST_CASE("a bag holds descriptors of one kind", "[bag][appearance]",
                   BagOfTopologyGraphs<>, IndexedBag) {
  std::mt19937 random(6);
  const TopologyGraph<> plain = realistic_graph(random, 5);
  const TopologyGraph<> one = with_appearance(random, plain, short_kind);
  const TopologyGraph<> other = with_appearance(random, plain, AppearanceKind("other", 8));
  TestType bag;
  CHECK(bag.appearance_kind() == AppearanceKind{});
  bag.add(KeyframeId{0}, plain);
  bag.add(KeyframeId{1}, one);
  bag.add(KeyframeId{2}, plain);
  CHECK(bag.appearance_kind() == short_kind);
  const auto sentence =
      "the key frame has descriptors of another kind (8 numbers) than those before it (8): "
      "describe all objects by one method";
  CHECK(error_text([&] { bag.add(KeyframeId{3}, other); }) == sentence);
  CHECK(error_text([&] { bag.update(KeyframeId{1}, other); }) == sentence);
  CHECK(bag.size() == 3);
  CHECK_FALSE(bag.contains(KeyframeId{3}));
  CHECK(bag.find(KeyframeId{1})->appearance_kind() == short_kind);
  bag.update(KeyframeId{0}, one);
  const TestType copy = bag;
  CHECK(copy.appearance_kind() == short_kind);
  bag.clear();
  bag.add(KeyframeId{3}, other);
  CHECK(bag.appearance_kind() == other.appearance_kind());
  CHECK(copy.appearance_kind() == short_kind);
}

TEST_CASE("an indexed bag keeps its kind through compacting, sealing and merging",
          "[bag][appearance]") {
  std::mt19937 random(7);
  const TopologyGraph<> plain = realistic_graph(random, 3);
  IndexedBag bag, others;
  bag.add(KeyframeId{0}, with_appearance(random, plain, short_kind));
  for (std::uint64_t id = 1; id < 200; ++id) bag.add(KeyframeId{id}, plain);
  CHECK(bag.appearance_kind() == short_kind);
  bag.compact();
  CHECK(bag.appearance_kind() == short_kind);
  others.add(KeyframeId{0}, with_appearance(random, plain, AppearanceKind("other", 8)));
  CHECK(error_text([&] { bag.merge(*others.view()); }).find("the other bag has") == 0);
  CHECK(bag.size() == 200);
  IndexedBag bare;
  bare.add(KeyframeId{0}, plain);
  bare.merge(*bag.view());
  CHECK(bare.appearance_kind() == short_kind);
}
