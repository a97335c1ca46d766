// SPDX-License-Identifier: MIT
#pragma once

// Includes CGAL's triangulations, which are GPL-3.0-or-later or under a commercial licence.

#include <vector>

#include <topobag/edges/detail/bucket_sort.hpp>
#include <topobag/edges/detail/delaunay_planar.hpp>
#include <topobag/edges/edge_list.hpp>
#include <topobag/edges/projections.hpp>
#include <topobag/types/semantic_node.hpp>

namespace topobag {
inline namespace v0 {

/// Edge builder: the Delaunay triangulation of the nodes in a plane, by default the image plane of
/// the paper (section 3.3.2). Two nodes are joined when some circle through both is empty.
///
/// When: the paper's graph, and the default for one frame. Every node's neighbours in all
/// directions, whatever the scale. Its subsets keep fewer, surer edges: `GabrielEdges`,
/// `RelativeNeighborhoodEdges`, `MinimumSpanningTreeEdges`, each inside the one before.
///
/// Unique: exact, and one edge set for every order of the nodes, also where four or more lie on one
/// circle. There the coordinates break the tie, so a rotation of such a layout (a façade, a grid)
/// may turn its diagonals; in general position a rotation, or a change of scale, changes nothing.
/// Regional: a node that comes or goes changes only edges between its own neighbours.
///
/// Nodes without a place in the plane stay isolated. Nodes on one line give a path, two nodes an
/// edge. Of coincident nodes the first is triangulated, and each later one has one edge, to that
/// first twin: as in any Delaunay graph, a node's nearest neighbour is adjacent.
///
/// O(n log n) in general, O(n²) on contrived input. At most 3n − 6 edges (n ≥ 3).
/// Throws `InsertionError` with the node's index on coordinates that `validate_position` refuses.
template <typename Projection = ImagePlane>
struct DelaunayEdges2 {
  Projection projection{};  ///< nodes -> callable (node -> optional place in the plane)

  template <typename Scalar>
  EdgeList operator()(const std::vector<SemanticNode<Scalar>>& nodes) const {
    detail::PlanarDelaunay triangulation;
    EdgeList edges = detail::triangulate(triangulation, nodes, projection);
    detail::append_edges(triangulation, edges);
    detail::bucket_sort(edges, nodes.size());
    return edges;
  }
};

template <typename Projection>
DelaunayEdges2(Projection) -> DelaunayEdges2<Projection>;

}  // namespace v0
}  // namespace topobag
