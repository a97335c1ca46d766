// SPDX-License-Identifier: MIT
#include <cstddef>
#include <cstdint>
#include <optional>
#include <random>
#include <sstream>
#include <vector>

#include <topobag/bag/graph_codec.hpp>
#include <topobag/bag/snapshot.hpp>

#include "bag/realistic_graphs.hpp"
#include "catch.hpp"

using namespace topobag;

namespace {

/// A graph of which some views know how far they see.
TopologyGraph<> with_depth(std::mt19937& random) {
  const TopologyGraph<> plain = realistic_graph(random, 12);
  std::vector<View<>> views = plain.views();
  for (std::size_t i = 0; i < views.size(); i += 2) {
    DepthGrid::Levels levels;
    for (auto& level : levels) level = static_cast<DepthGrid::Level>(random() % 64);
    views[i].depth.emplace(levels, views[i].camera.width, views[i].camera.height);
  }
  return TopologyGraph<>(plain.nodes(), plain.edges(), views, plain.gravity());
}

}  // namespace

TEST_CASE("how far a view sees comes back to the last bit, for 61 bytes", "[bag][codec]") {
  std::mt19937 random(3);
  for (int trial = 0; trial < 50; ++trial) {
    const TopologyGraph<> graph = with_depth(random);
    const auto bytes = encode(graph);
    CHECK((bytes[0] & 15) == 2);
    const TopologyGraph<> back = decode(bytes);
    REQUIRE(back.views().size() == 3);
    for (std::size_t i = 0; i < 3; ++i) {
      REQUIRE(back.views()[i].depth.has_value() == (i != 1));
      if (i != 1) CHECK(back.views()[i].depth->levels() == graph.views()[i].depth->levels());
    }
    CHECK(encode(back) == bytes);
    const TopologyGraph<> plain(back.nodes(), back.edges(),
                                {back.views()[1], back.views()[1], back.views()[1]});
    CHECK((encode(plain)[0] & 15) == 1);
    auto blind = back.views();
    for (auto& view : blind) view.depth.reset();
    CHECK(bytes.size() <= encode(TopologyGraph<>(back.nodes(), back.edges(), blind)).size() + 2 * 61);
    CHECK((encode(graph, ViewSection::left_out)[0] & 15) == 1);
  }
}

TEST_CASE("a graph with depth is refused wherever it is cut off", "[bag][codec]") {
  std::mt19937 random(4);
  const auto good = encode(with_depth(random));
  for (std::size_t size = 0; size < good.size(); ++size) {
    CHECK_THROWS_AS(decode(good.data(), size), FormatError);
  }
}

TEST_CASE("depth of a view without an image is refused", "[bag][codec]") {
  detail::BitWriter writer;
  detail::put_header(writer, {2, true, false, false, true});
  detail::NodeColumns(std::vector<SemanticNode<>>{}).put(writer);
  detail::put_edges(writer, {}, 0);
  detail::ViewColumns(std::vector<View<>>(1)).put(writer);
  writer.put(1, 1);
  for (std::size_t i = 0; i < DepthGrid::Levels{}.size(); ++i) writer.put(1, 6);
  CHECK_THROWS_AS(decode(writer.take()), FormatError);
}

TEST_CASE("a map that is saved without its views says so in no later version", "[bag][codec]") {
  std::mt19937 random(5);
  BagOfTopologyGraphs<> bag;
  bag.add(KeyframeId{1}, with_depth(random));
  for (const ViewSection views : {ViewSection::kept, ViewSection::left_out}) {
    std::stringstream file;
    save(bag, file, {0, views});
    CHECK(inspect(file).codec_version == (views == ViewSection::kept ? 2U : 1U));
  }
}
