// SPDX-License-Identifier: MIT
#pragma once

// Includes CGAL's triangulations, which are GPL-3.0-or-later or under a commercial licence.

#include <cstddef>
#include <optional>
#include <vector>

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Triangulation_data_structure_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <topobag/edges/detail/delaunay_insertion.hpp>
#include <topobag/edges/edge_list.hpp>
#include <topobag/edges/insertion_error.hpp>
#include <topobag/edges/position_in_triangulation.hpp>
#include <topobag/edges/projections.hpp>
#include <topobag/types/semantic_node.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

using PlanarVertex = CGAL::Triangulation_vertex_base_with_info_2<NodeIndex, Kernel>;

/// CGAL's Delaunay triangulation; each finite vertex carries its index as info.
using PlanarDelaunay =
    CGAL::Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<PlanarVertex>>;

/// Triangulates the places that `projection` gives the nodes. Returns the edges between coincident
/// nodes, see `insert_points`. Throws `InsertionError` with the node's index.
template <typename Scalar, typename Projection>
EdgeList triangulate(PlanarDelaunay& triangulation, const std::vector<SemanticNode<Scalar>>& nodes,
                     const Projection& projection) {
  static_assert(is_projection_v<Projection, Scalar>,
                "topobag: a projection is callable as projection(nodes)(node) -> "
                "std::optional<Eigen::Vector2d>.");
  const auto project = projection(nodes);
  std::vector<IndexedPoint<Kernel::Point_2>> points;
  points.reserve(nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const std::optional<Eigen::Vector2d> place = project(nodes[i]);
    if (!place) continue;
    validate_position(*place, i);
    points.emplace_back(Kernel::Point_2(place->x(), place->y()), node_index(i));
  }
  return insert_points(triangulation, points);
}

/// The canonical form of one of CGAL's planar edges (a face and the number of the vertex opposite).
template <typename PlanarEdge>
Edge edge_of(const PlanarEdge& edge) {
  const auto& [face, i] = edge;
  return make_edge(face->vertex(CGAL::Triangulation_cw_ccw_2::cw(i))->info(),
                   face->vertex(CGAL::Triangulation_cw_ccw_2::ccw(i))->info());
}

/// Appends all finite edges, in no particular order.
template <typename Triangulation>
void append_edges(const Triangulation& triangulation, EdgeList& edges) {
  if (triangulation.dimension() < 2) {
    for (const auto& edge : triangulation.finite_edges()) edges.push_back(edge_of(edge));
    return;
  }
  // The faces, infinite ones included, pass every edge once in either sense; one of these is
  // canonical. Written so that no branch depends on it: that is faster than CGAL's own iterator.
  std::size_t size = edges.size();
  edges.resize(size + 3 * triangulation.number_of_vertices());
  const auto infinite = triangulation.infinite_vertex();  // its info is not set
  for (const auto face : triangulation.all_face_handles()) {
    bool finite[3];
    NodeIndex index[3];
    for (int i = 0; i < 3; ++i) {
      finite[i] = face->vertex(i) != infinite;
      index[i] = finite[i] ? face->vertex(i)->info() : NodeIndex{};
    }
    for (int i = 0; i < 3; ++i) {
      const int next = CGAL::Triangulation_cw_ccw_2::ccw(i);
      edges[size] = {index[i], index[next]};
      size += static_cast<std::size_t>(finite[i] & (index[i] < index[next]));
    }
  }
  edges.resize(size);
}

/// The canonical form of one of CGAL's finite faces.
template <typename FaceHandle>
Triangle triangle_of(FaceHandle face) {
  return make_triangle(face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info());
}

/// Calls `visit(vertex handle)` for each finite neighbour of `vertex`, counterclockwise.
template <typename Triangulation, typename VertexHandle, typename Visit>
void for_each_neighbor(const Triangulation& triangulation, VertexHandle vertex, Visit visit) {
  if (triangulation.dimension() < 1) return;
  auto neighbor = triangulation.incident_vertices(vertex);
  const auto first = neighbor;
  do {
    if (!triangulation.is_infinite(neighbor)) visit(VertexHandle(neighbor));
  } while (++neighbor != first);
}

}  // namespace detail
}  // namespace v0
}  // namespace topobag
