// SPDX-License-Identifier: MIT
#pragma once

// Includes CGAL's triangulations, which are GPL-3.0-or-later or under a commercial licence.

#include <cstddef>
#include <limits>
#include <vector>

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Triangulation_data_structure_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <topobag/edges/detail/bucket_sort.hpp>
#include <topobag/edges/detail/delaunay_insertion.hpp>
#include <topobag/edges/edge_list.hpp>
#include <topobag/edges/insertion_error.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

using PlanarVertexBase = CGAL::Triangulation_vertex_base_with_info_2<NodeIndex, Kernel>;

/// CGAL's Delaunay triangulation; each finite vertex carries its index.
using PlanarDelaunay =
    CGAL::Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<PlanarVertexBase>>;

/// Triangulates the places that `projection` gives the nodes. Returns the edges between coincident
/// nodes. Throws `InsertionError` with the node's index.
template <typename Nodes, typename Projection>
EdgeList triangulate(PlanarDelaunay& triangulation, const Nodes& nodes,
                     const Projection& projection) {
  const auto project = projection(nodes);
  std::vector<IndexedPoint<Kernel::Point_2>> points;
  points.reserve(nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const auto place = project(nodes[i]);
    if (!place) continue;
    validate_position(*place, i);
    points.emplace_back(Kernel::Point_2(place->x(), place->y()), node_index(i));
  }
  return insert_points(triangulation, points);
}

/// The finite edges, in no particular order.
template <typename Triangulation>
EdgeList finite_edges(const Triangulation& triangulation) {
  EdgeList edges;
  edges.reserve(3 * triangulation.number_of_vertices());
  for (const auto& [face, i] : triangulation.finite_edges()) {
    edges.push_back(make_edge(face->vertex(triangulation.cw(i))->info(),
                              face->vertex(triangulation.ccw(i))->info()));
  }
  return edges;
}

/// The finite edges and the edges between coincident nodes, in canonical order.
inline EdgeList canonical_edges(const PlanarDelaunay& triangulation, const EdgeList& twins,
                                std::size_t num_nodes) {
  EdgeList edges = finite_edges(triangulation);
  edges.insert(edges.end(), twins.begin(), twins.end());
  return bucket_sort(edges, num_nodes);
}

}  // namespace detail
}  // namespace v0
}  // namespace topobag
