// SPDX-License-Identifier: MIT
#include <cmath>
#include <functional>
#include <limits>
#include <optional>

#include <topobag/edges/complete_edges.hpp>
#include <topobag/edges/radius_edges.hpp>
#include <topobag/graph/topology_graph.hpp>

#include "catch.hpp"
#include "random_graphs.hpp"

using namespace topobag;

namespace {

SemanticNode<> placed(double x, double y, double z) {
  SemanticNode<> node;
  node.position = Eigen::Vector3d(x, y, z);
  return node;
}

Edge edge(std::size_t i, std::size_t j) { return make_edge(node_index(i), node_index(j)); }

/// The index carried by the InvalidValue that `make` throws.
std::optional<std::size_t> thrown_index(const std::function<void()>& make) {
  try {
    make();
  } catch (const InvalidValue& error) {
    return error.index();
  }
  return std::nullopt;
}

}  // namespace

TEST_CASE("eq. 4: an edge is as long as its ends are apart", "[graph][paper]") {
  const TopologyGraph<> graph({placed(0, 0, 1), placed(3, 4, 1), placed(0, 0, 3)},
                              {edge(0, 1), edge(0, 2)});
  CHECK(graph.lengths() == std::vector<double>{5.0, 2.0});
  CHECK(graph.edges() == EdgeList{edge(0, 1), edge(0, 2)});
}

TEST_CASE("edges are made canonical, lengths stay parallel", "[graph]") {
  std::mt19937 random(11);
  for (std::size_t n = 0; n < 20; ++n) {
    const auto nodes = random_nodes(random, n, 4, false);
    EdgeList messy;
    for (const Edge& e : CompleteEdges{}(nodes)) {
      messy.push_back(e);
      messy.push_back({e.b, e.a});
    }
    std::shuffle(messy.begin(), messy.end(), random);
    const TopologyGraph<> graph(nodes, messy);

    std::size_t expected = 0;
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = i + 1; j < n; ++j) {
        if (!nodes[i].position || !nodes[j].position) continue;
        REQUIRE(expected < graph.edges().size());
        CHECK(graph.edges()[expected] == edge(i, j));
        CHECK(graph.lengths()[expected] == (*nodes[i].position - *nodes[j].position).norm());
        ++expected;
      }
    }
    CHECK(graph.edges().size() == expected);
    CHECK(graph.lengths().size() == expected);
  }
}

TEST_CASE("the smallest graphs", "[graph]") {
  const TopologyGraph<> empty;
  CHECK(empty.empty());
  CHECK(empty.size() == 0);
  CHECK_FALSE(empty.is_matchable());
  CHECK(make_topology_graph(std::vector<SemanticNode<>>{}, CompleteEdges{}).empty());

  const TopologyGraph<> one({placed(0, 0, 1)});
  CHECK(one.size() == 1);
  CHECK(one.edges().empty());

  const TopologyGraph<> coincident({placed(1, 1, 1), placed(1, 1, 1)}, {edge(0, 1)});
  CHECK(coincident.lengths() == std::vector<double>{0.0});
}

TEST_CASE("three nodes with a position make a graph matchable", "[graph]") {
  std::vector<SemanticNode<>> nodes{placed(0, 0, 1), SemanticNode<>{}, placed(1, 0, 1)};
  CHECK_FALSE(TopologyGraph<>(nodes).is_matchable());
  nodes.push_back(placed(2, 0, 1));
  CHECK(TopologyGraph<>(nodes).is_matchable());
}

TEST_CASE("an edge without two ends is refused with its index", "[graph]") {
  const std::vector<SemanticNode<>> nodes(3);
  const auto make = [&](Edge bad) {
    return thrown_index([&] { TopologyGraph<>(nodes, {edge(0, 1), edge(1, 2), bad}); });
  };
  CHECK(make({node_index(1), node_index(1)}) == 2u);
  CHECK(make({node_index(0), node_index(3)}) == 2u);
  CHECK(make({node_index(7), node_index(0)}) == 2u);
  CHECK_FALSE(make(edge(0, 2)).has_value());
}

TEST_CASE("a number that is not finite is refused with the node's index", "[graph]") {
  std::mt19937 random(5);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  const std::vector<std::function<void(SemanticNode<>&, double)>> spoil{
      [](SemanticNode<>& n, double bad) { n.pixel->x() = bad; },
      [](SemanticNode<>& n, double bad) { n.pixel->y() = bad; },
      [](SemanticNode<>& n, double bad) { n.z = bad; },
      [](SemanticNode<>& n, double bad) { n.position->z() = bad; },
      [](SemanticNode<>& n, double bad) { n.covariance(1, 2) = bad; },
      [](SemanticNode<>& n, double bad) { n.size.x() = bad; },
      [](SemanticNode<>& n, double bad) { n.confidence = bad; },
      [](SemanticNode<>& n, double bad) { n.existence = bad; }};
  for (const auto& spoil_one : spoil) {
    for (const double bad : {nan, inf, -inf}) {
      auto nodes = random_nodes(random, 6);
      const std::size_t index = random() % 6;
      spoil_one(nodes[index], bad);
      CHECK(thrown_index([&] { TopologyGraph<>{nodes}; }) == index);
    }
  }
}

TEST_CASE("the builder's edges are the graph's", "[graph]") {
  std::mt19937 random(3);
  const auto nodes = random_nodes(random, 12);
  CHECK(make_topology_graph(nodes, RadiusEdges{1.5}).edges() == RadiusEdges{1.5}(nodes));
  const auto no_edges = [](const std::vector<SemanticNode<>>&) { return EdgeList{}; };
  CHECK(make_topology_graph(nodes, no_edges).edges().empty());
  STATIC_REQUIRE(is_edge_builder_v<RadiusEdges, float>);
  STATIC_REQUIRE_FALSE(is_edge_builder_v<int, double>);
}

TEST_CASE("a covariance that is no covariance is refused with the node's index",
          "[graph][regression]") {
  std::mt19937 random(6);
  Eigen::Matrix3d tilted = Eigen::Matrix3d::Identity();
  tilted(0, 2) = tilted(2, 0) = 1.5;  // correlated by more than 1
  for (const Eigen::Matrix3d& bad :
       {Eigen::Matrix3d(-1e-4 * Eigen::Matrix3d::Identity()), tilted,
        Eigen::Matrix3d(Eigen::Vector3d(0, 0, 0.04).asDiagonal()),  // of the depth alone
        Eigen::Matrix3d(Eigen::Vector3d(0.01, 0, 0.04).asDiagonal()),
        Eigen::Matrix3d(Eigen::Vector3d(0.01, 0.01, -0.04).asDiagonal())}) {
    auto nodes = random_nodes(random, 6);
    nodes[4].covariance = bad;
    CHECK(thrown_index([&] { TopologyGraph<>{nodes}; }) == 4u);
  }
  auto nodes = random_nodes(random, 6);
  nodes[4].covariance = Eigen::Vector3d(1e-12, 1.0, 1.0).asDiagonal();
  nodes[5].covariance.setZero();  // not modelled
  CHECK(TopologyGraph<>{nodes}.size() == 6);
}

TEST_CASE("a view's pose that is no rigid motion is refused", "[graph]") {
  View<> mirrored;
  mirrored.T_graph_camera.linear()(0, 0) = -1.0;
  CHECK_THROWS_AS(TopologyGraph<>({}, {}, {mirrored}), InvalidValue);
  CHECK(TopologyGraph<>({}, {}, {View<>{}}).views().size() == 1);
}

TEST_CASE("the nodes of a graph are described by one method", "[graph][appearance]") {
  std::vector<SemanticNode<>> nodes{placed(0, 0, 1), placed(1, 0, 1), placed(2, 0, 1)};
  CHECK(TopologyGraph<>(nodes).appearance_kind() == AppearanceKind{});
  nodes[1].appearance = Appearance(AppearanceKind("a", 2), Appearance::Bytes{1, 2});
  CHECK(TopologyGraph<>(nodes).appearance_kind() == AppearanceKind("a", 2));
  nodes[2].appearance = Appearance(AppearanceKind("a", 3), Appearance::Bytes{1, 2, 3});
  try {
    const TopologyGraph<> graph(nodes);
    FAIL("two kinds in one graph");
  } catch (const InvalidValue& error) {
    CHECK(error.index() == 2U);
    CHECK(std::string(error.what()).find("node 2 has descriptors of another kind (3 numbers)") ==
          0);
  }
}
