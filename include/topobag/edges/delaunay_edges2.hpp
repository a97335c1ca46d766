// SPDX-License-Identifier: MIT
#pragma once

// Includes CGAL's triangulations, which are GPL-3.0-or-later or under a commercial licence.

#include <vector>

#include <Eigen/Core>

#include <topobag/edges/detail/delaunay_planar.hpp>
#include <topobag/edges/edge_list.hpp>
#include <topobag/edges/projections.hpp>
#include <topobag/types/semantic_node.hpp>

namespace topobag {
inline namespace v0 {

/// Edge builder: the Delaunay triangulation of the nodes in a plane, by default the image plane of
/// the paper (section 3.3.2).
///
/// Exact, deterministic, and one edge set for every order of the nodes, also where four or more lie
/// on one circle: ties are broken by the coordinates. So a rotation of such a layout (a façade, a
/// grid) may turn its diagonals; in general position a rotation changes nothing.
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
    const EdgeList twins = detail::triangulate(triangulation, nodes, projection);
    return detail::canonical_edges(triangulation, twins, nodes.size());
  }
};

}  // namespace v0
}  // namespace topobag
