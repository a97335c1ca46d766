// SPDX-License-Identifier: MIT
// MISFIT 1: topobag: a vertex needs a position: specialise topobag::PositionTraits<Vertex>
// MISFIT 2: topobag: a hint has suggest(const Eigen::Vector2d&) const -> std::optional<NodeIndex>
// MISFIT 3: topobag: a projection is callable as projection(nodes)(node)
#include <topobag/edges/delaunay_edges2.hpp>
#include <topobag/edges/delaunay_triangulation.hpp>

using namespace topobag;

struct Landmark {
  double east, north;
};

#if MISFIT != 1
template <>
struct topobag::PositionTraits<Landmark> {
  static Eigen::Vector2d position(const Landmark& l) { return {l.east, l.north}; }
};
#endif

struct NoHint {
  std::optional<NodeIndex> suggest(const Eigen::Vector2d&) const { return std::nullopt; }
#if MISFIT != 2
  void notice(NodeIndex) const {}
#endif
};

struct FrontPlane {
#if MISFIT == 3
  Eigen::Vector2d operator()(const SemanticNode<>& node) const { return *node.pixel; }
#else
  auto operator()(const std::vector<SemanticNode<>>&) const {
    return [](const SemanticNode<>& node) { return *node.pixel; };
  }
#endif
};

int main() {
#if MISFIT != 3
  DelaunayTriangulation<Landmark, NoHint> map;
  map.insert({1.0, 2.0});
#endif
#if MISFIT == 0 || MISFIT == 3
  const EdgeList edges = DelaunayEdges2<FrontPlane>{}(std::vector<SemanticNode<>>{});
#endif
}
