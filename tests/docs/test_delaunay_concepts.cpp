// SPDX-License-Identifier: MIT
// The models of examples/docs/concepts.md that need CGAL.
#include <optional>
#include <string>
#include <vector>

#include <topobag/edges/delaunay_edges2.hpp>
#include <topobag/edges/delaunay_edges3.hpp>
#include <topobag/edges/delaunay_triangulation.hpp>
#include <topobag/edges/gabriel_edges.hpp>
#include <topobag/edges/minimum_spanning_tree_edges.hpp>
#include <topobag/edges/relative_neighborhood_edges.hpp>
#include <topobag/graph/topology_graph.hpp>

#include "catch.hpp"
#include "random_graphs.hpp"

using namespace topobag;

namespace {

struct FrontPlane {
  template <typename Scalar>
  auto operator()(const std::vector<SemanticNode<Scalar>>&) const {
    return [](const SemanticNode<Scalar>& node) -> std::optional<Eigen::Vector2d> {
      if (!node.position) return std::nullopt;
      return node.position->template head<2>().template cast<double>();
    };
  }
};

struct Landmark {
  double east, north;  // m
  std::string name;
};

struct NoHint {
  std::optional<NodeIndex> suggest(const Eigen::Vector2d&) const { return std::nullopt; }
  void notice(NodeIndex) const {}
};

}  // namespace

template <>
struct topobag::PositionTraits<Landmark> {
  static Eigen::Vector2d position(const Landmark& l) { return {l.east, l.north}; }
};

static_assert(has_position_v<Landmark> && has_position_v<Eigen::Vector2f> &&
              has_position_v<SemanticNode<>>);
static_assert(!has_position_v<int>);
static_assert(is_hint_v<NoHint> && is_hint_v<LastUsedVertexHint> && is_hint_v<HierarchyHint>);
static_assert(is_projection_v<FrontPlane, float> && is_projection_v<ImagePlane, double> &&
              is_projection_v<GroundPlane, double> && is_projection_v<BestFitPlane, double>);
static_assert(is_edge_builder_v<DelaunayEdges2<>, double> &&
              is_edge_builder_v<DelaunayEdges2<BestFitPlane>, double> &&
              is_edge_builder_v<DelaunayEdges2<GroundPlane>, double> &&
              is_edge_builder_v<DelaunayEdges3, double> &&
              is_edge_builder_v<GabrielEdges<>, double> &&
              is_edge_builder_v<RelativeNeighborhoodEdges<>, double> &&
              is_edge_builder_v<MinimumSpanningTreeEdges<>, double>);

TEST_CASE("concepts: a plane, a vertex and a hint", "[docs][delaunay]") {
  std::mt19937 random(1);
  const auto nodes = random_nodes(random, 10);
  CHECK(make_topology_graph(nodes, DelaunayEdges2{FrontPlane{}}).edges().size() >= 9);
  // As choosing.md has them.
  const Gravity<> gravity;
  CHECK(make_topology_graph(nodes, DelaunayEdges2{GroundPlane(gravity.down)}).edges().size() >= 9);
  CHECK(make_topology_graph(nodes, DelaunayEdges2{BestFitPlane{}}).edges().size() >= 9);

  DelaunayTriangulation<Landmark, NoHint> map;
  const NodeIndex tower = map.insert({0.0, 0.0, "tower"});
  map.insert({1.0, 0.0, "gate"});
  map.insert({0.0, 1.0, "well"});
  CHECK(map.size() == 3);
  CHECK(map.nearest_neighbor({0.1, 0.1}) == tower);
}
