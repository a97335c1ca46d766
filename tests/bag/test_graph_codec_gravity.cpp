// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include <topobag/bag/detail/codec/node_scan.hpp>
#include <topobag/bag/graph_codec.hpp>
#include <topobag/bag/indexed_bag.hpp>
#include <topobag/bag/snapshot.hpp>

#include "bag/realistic_graphs.hpp"
#include "bag/saved_bags.hpp"
#include "catch.hpp"

using namespace topobag;

namespace {

using Bytes = std::vector<std::uint8_t>;

Gravity<> random_gravity(std::mt19937& random) {
  std::normal_distribution<double> normal;
  return {{normal(random), normal(random), normal(random)}, 0.02 * std::exp(normal(random))};
}

TopologyGraph<> with_gravity(const TopologyGraph<>& graph, const Gravity<>& gravity) {
  return TopologyGraph<>(graph.nodes(), graph.edges(), graph.views(), gravity);
}

}  // namespace

TEST_CASE("gravity comes back from a graph's bytes", "[bag][codec][gravity]") {
  std::mt19937 random(1);
  for (int trial = 0; trial < 300; ++trial) {
    const TopologyGraph<> plain = realistic_graph(random, random() % 30, trial % 2 == 0);
    const TopologyGraph<> graph = with_gravity(plain, random_gravity(random));
    const Bytes bytes = encode(graph);
    const TopologyGraph<> back = decode(bytes);
    REQUIRE(back.gravity());
    CHECK(back.gravity()->down.cross(graph.gravity()->down).norm() < 0.3e-3);
    CHECK(back.gravity()->down.dot(graph.gravity()->down) > 0.0);
    CHECK(back.gravity()->deviation == Approx(graph.gravity()->deviation).epsilon(0.045));
    CHECK(encode(TopologyGraph<>(back.nodes(), back.edges(), back.views())) == encode(plain));
    CHECK(encode(back) == bytes);
    const Bytes as_float = encode(decode<float>(bytes));
    CHECK(encode(decode<float>(as_float)) == as_float);
    CHECK(bytes.size() <= encode(plain).size() + 5);
  }
}

TEST_CASE("a graph is written in the least version that holds it", "[bag][codec][gravity]") {
  std::mt19937 random(2);
  const TopologyGraph<> plain = realistic_graph(random, 12);
  CHECK(codec_version_for(plain) == 1);
  CHECK((encode(plain)[0] & 15) == 1);
  const TopologyGraph<> graph = with_gravity(plain, {});
  CHECK(codec_version_for(graph) == 2);
  CHECK((encode(graph)[0] & 15) == 2);
}

TEST_CASE("the bytes of version 1 and of version 2", "[bag][codec][gravity]") {
  CHECK(encode(TopologyGraph<>{}) == Bytes{0x01, 0x04});
  const TopologyGraph<> down({}, {}, {}, Gravity<>{});
  // fixed(4) 2, fixed(1) 0 1 0 0; 0 nodes; edges as bits; 8191 + 0; 8191 + 8191; 96 - 47.
  CHECK(encode(down) == Bytes{0x22, 0xE0, 0xFF, 0xE7, 0xFF, 0xC7, 0x00});
  CHECK(decode(encode(down)).gravity()->down == Eigen::Vector3d::UnitY());
}

TEST_CASE("version 2 without a section of its own is a graph of version 1",
          "[bag][codec][gravity]") {
  detail::BitWriter writer;
  detail::put_header(writer, {2, false, false, false, false});
  writer.put_number(0);
  writer.put(1, 1);
  const TopologyGraph<> graph = decode(writer.take());
  CHECK_FALSE(graph.gravity());
  CHECK(encode(graph) == encode(TopologyGraph<>{}));
}

TEST_CASE("a graph with gravity is refused wherever it is cut off", "[bag][codec][gravity]") {
  std::mt19937 random(3);
  const Bytes good = encode(with_gravity(realistic_graph(random, 8), random_gravity(random)));
  for (std::size_t size = 0; size < good.size(); ++size) {
    CHECK_THROWS_AS(decode(good.data(), size), FormatError);
  }
  for (std::size_t bit = 0; bit < 8 * good.size(); ++bit) {
    Bytes flipped = good;
    flipped[bit / 8] = static_cast<std::uint8_t>(flipped[bit / 8] ^ 1U << bit % 8);
    try {
      const Bytes once = encode(decode(flipped));
      CHECK(encode(decode(once)) == once);
    } catch (const FormatError&) {
    }
  }
}

TEST_CASE("the scan of the nodes reads both versions", "[bag][codec][gravity]") {
  std::mt19937 random(4);
  detail::NodeScan scan_plain, scan;
  for (int trial = 0; trial < 100; ++trial) {
    const TopologyGraph<> plain = realistic_graph(random, random() % 30);
    Bytes version1 = encode(plain), version2 = encode(with_gravity(plain, random_gravity(random)));
    for (Bytes* bytes : {&version1, &version2}) {
      bytes->insert(bytes->end(), detail::scan_margin, 0);
    }
    const auto& expected = scan_plain(version1.data());
    const auto& nodes = scan(version2.data());
    REQUIRE(nodes.size() == expected.size());
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      CHECK(nodes[i].label == expected[i].label);
      CHECK(nodes[i].size == expected[i].size);
      CHECK(nodes[i].position == expected[i].position);
    }
  }
}

TEST_CASE("bags keep gravity, and their files say the latest version in them",
          "[bag][snapshot][gravity]") {
  std::mt19937 random(5);
  BagOfTopologyGraphs<> bag = random_bag(random, 6);
  const auto version_of = [](const std::string& bytes) {
    std::istringstream stream(bytes);
    return inspect(stream).codec_version;
  };
  CHECK(version_of(saved(bag)) == 1);
  const KeyframeId changed{2 * 1000003U};
  bag.update(changed, with_gravity(*bag.find(changed), {{0, 0, -1}, 0.02}));
  const std::string bytes = saved(bag);
  CHECK(version_of(bytes) == 2);
  const BagOfTopologyGraphs<> back = loaded(bytes);
  CHECK(saved(back) == bytes);
  back.for_each([&](KeyframeId id, const EntryInfo&, const TopologyGraph<>& graph) {
    CHECK(graph.gravity().has_value() == (id == changed));
  });
  CHECK(back.find(changed)->gravity()->down == -Eigen::Vector3d::UnitZ());

  std::istringstream stream(bytes);
  const IndexedBag indexed = load<IndexedBag>(stream);
  CHECK(saved(*indexed.view()) == bytes);
  const TopologyGraph<> query = *bag.find(KeyframeId{0});
  CHECK(indexed.view()->query(query) == back.query(query));
}
