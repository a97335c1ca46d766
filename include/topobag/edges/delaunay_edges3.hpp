// SPDX-License-Identifier: MIT
#pragma once

// Includes CGAL's triangulations, which are GPL-3.0-or-later or under a commercial licence.

#include <cstddef>
#include <vector>

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Triangulation_data_structure_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <topobag/edges/detail/bucket_sort.hpp>
#include <topobag/edges/detail/delaunay_insertion.hpp>
#include <topobag/edges/edge_list.hpp>
#include <topobag/edges/insertion_error.hpp>
#include <topobag/types/semantic_node.hpp>

namespace topobag {
inline namespace v0 {

/// Edge builder: the Delaunay triangulation of the nodes' positions in space. Two nodes are joined
/// when some sphere through both is empty.
///
/// When: positions are good and the view may change a lot, since unlike the image plane's these
/// edges do not depend on where the camera stands. They are many (about 7 a node, n²/2 at worst),
/// and depth noise flips them easily between nodes on one wall: there `DelaunayEdges2` with
/// `GroundPlane` or `BestFitPlane` is steadier.
///
/// Unique, regional, and bound to the coordinates on cospherical layouts as `DelaunayEdges2` on
/// cocircular ones. Nodes without a position stay isolated. Nodes in one plane give its planar
/// triangulation, nodes on one line a path. Of coincident nodes the first is triangulated, and each
/// later one has one edge, to that first twin.
///
/// O(n log n) in general, O(n²) at worst. Throws `InsertionError` with the node's index on
/// coordinates that `validate_position` refuses.
struct DelaunayEdges3 {
  template <typename Scalar>
  EdgeList operator()(const std::vector<SemanticNode<Scalar>>& nodes) const {
    using Vertex = CGAL::Triangulation_vertex_base_with_info_3<NodeIndex, detail::Kernel>;
    using Point = detail::Kernel::Point_3;

    std::vector<detail::IndexedPoint<Point>> points;
    points.reserve(nodes.size());
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      if (!nodes[i].position) continue;
      const Eigen::Vector3d place = nodes[i].position->template cast<double>();
      validate_position(place, i);
      points.emplace_back(Point(place.x(), place.y(), place.z()), node_index(i));
    }

    CGAL::Delaunay_triangulation_3<detail::Kernel, CGAL::Triangulation_data_structure_3<Vertex>>
        triangulation;
    EdgeList edges = detail::insert_points(triangulation, points);
    for (const auto& [cell, i, j] : triangulation.finite_edges()) {
      edges.push_back(make_edge(cell->vertex(i)->info(), cell->vertex(j)->info()));
    }
    detail::bucket_sort(edges, nodes.size());
    return edges;
  }
};

}  // namespace v0
}  // namespace topobag
