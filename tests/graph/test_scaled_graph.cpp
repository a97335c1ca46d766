// SPDX-License-Identifier: MIT
#include <array>
#include <cstddef>
#include <limits>
#include <random>
#include <vector>

#include <Eigen/Geometry>

#include <topobag/error.hpp>
#include <topobag/graph/detail/rescaled.hpp>
#include <topobag/graph/scaled_graph.hpp>

#include "catch.hpp"
#include "random_graphs.hpp"

using namespace topobag;

namespace {

/// With views, occluders, depth, covariances, gravity and nodes without a position.
TopologyGraph<> full_graph(std::mt19937& random) {
  std::vector<SemanticNode<>> nodes = random_nodes(random, 9, 3, false);
  for (auto& node : nodes) node.covariance = Eigen::Vector3d(1e-4, 2e-4, 9e-4).asDiagonal();
  const auto wall = [](const Eigen::Vector2d&) { return std::optional<double>(2.0); };
  View<> view;
  view.T_graph_camera = Eigen::Translation3d(0.3, -0.2, 0.1) * Eigen::Quaterniond::Identity();
  view.camera = PinholeCamera<>{500.0, 500.0, 320.0, 240.0, 640, 480};
  view.occluders = {{BoundingBox{10.0, 20.0, 60.0, 90.0}, 1.5},
                    {BoundingBox{1.0, 2.0, 3.0, 4.0}, 0.0}};
  view.depth = DepthGrid(wall, 640, 480);
  return TopologyGraph<>(nodes, KnnEdges{3}(nodes), {view},
                         Gravity<>{Eigen::Vector3d::UnitY(), 0.02});
}

}  // namespace

TEST_CASE("a scaled graph has all its lengths times a factor, and nothing else", "[graph]") {
  std::mt19937 random(2202);
  for (const double factor : {0.3, 1.0, 2.0}) {
    const TopologyGraph<> graph = full_graph(random);
    const TopologyGraph<> other = scaled(graph, factor);
    REQUIRE(other.size() == graph.size());
    for (std::size_t i = 0; i < graph.size(); ++i) {
      const SemanticNode<>&a = graph.nodes()[i], &b = other.nodes()[i];
      CHECK(b.label == a.label);
      CHECK(b.pixel == a.pixel);
      CHECK(b.z == factor * a.z);
      REQUIRE(b.position.has_value() == a.position.has_value());
      if (a.position) CHECK(b.position->isApprox(factor * *a.position));
      CHECK(b.covariance.isApprox(factor * factor * a.covariance));
      CHECK(b.size.isApprox(factor * a.size));
    }
    CHECK(other.edges() == graph.edges());
    for (std::size_t i = 0; i < graph.lengths().size(); ++i) {
      CHECK(other.lengths()[i] == Approx(factor * graph.lengths()[i]));
    }
    const View<>&a = graph.views().at(0), &b = other.views().at(0);
    CHECK(b.T_graph_camera.translation().isApprox(factor * a.T_graph_camera.translation()));
    CHECK(b.T_graph_camera.linear() == a.T_graph_camera.linear());
    CHECK(b.occluders[0].z == factor * a.occluders[0].z);
    CHECK(b.occluders[1].z == 0.0);
    CHECK(other.gravity()->down == graph.gravity()->down);
  }
}

TEST_CASE("what a scaled graph's cameras see does not depend on the unit", "[graph]") {
  std::mt19937 random(2203);
  std::uniform_real_distribution<double> across(-1.0, 1.0), along(0.6, 4.0);
  const TopologyGraph<> graph = full_graph(random);
  const double factor = 2.0;  // whole octaves, so that the depth is not rounded
  const TopologyGraph<> other = scaled(graph, factor);
  std::size_t shown = 0, seen_through = 0;
  for (int i = 0; i < 500; ++i) {
    const double x = across(random), y = across(random), z = along(random);
    const Eigen::Vector3d point(x, y, z), moved = factor * point;
    const View<>&a = graph.views()[0], &b = other.views()[0];
    CHECK(a.should_show(point, 5.0, 3.0) == b.should_show(moved, 5.0, 3.0 * factor));
    CHECK(a.sees_through(point, 5.0, 3.0, 0.2) ==
          b.sees_through(moved, 5.0, 3.0 * factor, 0.2 * factor));
    shown += a.should_show(point, 5.0, 3.0) ? 1U : 0U;
    seen_through += a.sees_through(point, 5.0, 3.0, 0.2) ? 1U : 0U;
  }
  CHECK(shown > 50);
  CHECK(seen_through > 50);
}

TEST_CASE("a graph is scaled by a positive number alone", "[graph]") {
  for (const double factor : {0.0, -1.0, std::numeric_limits<double>::infinity(),
                              std::numeric_limits<double>::quiet_NaN()}) {
    CHECK_THROWS_AS(scaled(TopologyGraph<>{}, factor), InvalidValue);
  }
}

TEST_CASE("a graph in its own unit is not copied", "[graph]") {
  std::mt19937 random(2204);
  const TopologyGraph<> graph = full_graph(random);
  CHECK(&*detail::Rescaled<TopologyGraph<>>(graph, 1.0) == &graph);
  const detail::Rescaled<TopologyGraph<>> other(graph, 1.5);
  CHECK(&*other != &graph);
  CHECK((*other).lengths() == scaled(graph, 1.5).lengths());
}

namespace {

/// A user's own kind of graph, of which nothing says how it is scaled.
struct UnscalableGraph {};

}  // namespace

TEST_CASE("a graph of a kind that cannot be scaled stays in its unit", "[graph]") {
  const UnscalableGraph graph;
  CHECK(&*detail::Rescaled<UnscalableGraph>(graph, 1.0) == &graph);
  CHECK_THROWS_AS(detail::Rescaled<UnscalableGraph>(graph, 2.0), InvalidValue);
}
