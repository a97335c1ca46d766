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

/// Edge builder: the Gabriel graph in a plane. Two nodes are joined when the closed disc that has
/// them as diameter holds no third node: those Delaunay edges that nobody stands in the way of.
///
/// When: Delaunay's long edges along the hull come and go with every missed detection; most of
/// these are not Gabriel edges, and the graph stays connected. About 2n edges.
///
/// The disc is closed, so the edges depend on distances alone: a rotation changes nothing even on
/// cocircular layouts (as far as it is exact), and a grid has no diagonals. Unique and regional as
/// `DelaunayEdges2`, with the same results for missing, collinear and coincident nodes, the same
/// complexity and the same errors.
template <typename Projection = ImagePlane>
struct GabrielEdges {
  Projection projection{};  ///< nodes -> callable (node -> optional place in the plane)

  template <typename Scalar>
  EdgeList operator()(const std::vector<SemanticNode<Scalar>>& nodes) const {
    detail::PlanarDelaunay triangulation;
    EdgeList edges = detail::triangulate(triangulation, nodes, projection);
    for (const auto& edge : triangulation.finite_edges()) {
      if (is_gabriel(triangulation, edge)) edges.push_back(detail::edge_of(edge));
    }
    detail::bucket_sort(edges, nodes.size());
    return edges;
  }

 private:
  /// If any node lies in the disc of a Delaunay edge, then the apex of one of its two triangles.
  static bool is_gabriel(const detail::PlanarDelaunay& triangulation,
                         const detail::PlanarDelaunay::Edge& edge) {
    if (triangulation.dimension() < 2) return true;
    const auto& [face, i] = edge;
    const auto& p = face->vertex(triangulation.cw(i))->point();
    const auto& q = face->vertex(triangulation.ccw(i))->point();
    for (const auto& apex : {face->vertex(i), triangulation.mirror_vertex(face, i)}) {
      if (triangulation.is_infinite(apex)) continue;
      if (CGAL::side_of_bounded_circle(p, q, apex->point()) != CGAL::ON_UNBOUNDED_SIDE) {
        return false;
      }
    }
    return true;
  }
};

template <typename Projection>
GabrielEdges(Projection) -> GabrielEdges<Projection>;

}  // namespace v0
}  // namespace topobag
