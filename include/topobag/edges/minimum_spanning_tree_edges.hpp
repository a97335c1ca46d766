// SPDX-License-Identifier: MIT
#pragma once

// Includes CGAL's triangulations, which are GPL-3.0-or-later or under a commercial licence.

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

#include <topobag/edges/detail/bucket_sort.hpp>
#include <topobag/edges/detail/delaunay_planar.hpp>
#include <topobag/edges/edge_list.hpp>
#include <topobag/edges/projections.hpp>
#include <topobag/types/semantic_node.hpp>

namespace topobag {
inline namespace v0 {

/// Edge builder: the Euclidean minimum spanning tree in a plane, by Kruskal's rule over the
/// Delaunay edges with exact comparisons of length.
///
/// When: the fewest edges that keep the graph in one piece, n − 1. One missing node may move the
/// tree far away, so prefer `RelativeNeighborhoodEdges` where detections flicker.
///
/// Of edges of equal length the smaller in canonical order goes first; so where lengths tie, and
/// only there, the tree depends on how the nodes are numbered. It depends on distances alone, as
/// its superset `RelativeNeighborhoodEdges`; same results for missing, collinear and coincident
/// nodes, and same errors. O(n log n) in general, O(n²) on contrived input.
template <typename Projection = ImagePlane>
struct MinimumSpanningTreeEdges {
  Projection projection{};  ///< nodes -> callable (node -> optional place in the plane)

  template <typename Scalar>
  EdgeList operator()(const std::vector<SemanticNode<Scalar>>& nodes) const {
    detail::PlanarDelaunay triangulation;
    EdgeList edges = detail::triangulate(triangulation, nodes, projection);
    Components components(nodes.size());
    for (const Segment& segment : segments_by_length(triangulation)) {
      if (components.join(value(segment.edge.a), value(segment.edge.b))) {
        edges.push_back(segment.edge);
      }
    }
    detail::bucket_sort(edges, nodes.size());
    return edges;
  }

 private:
  struct Segment {
    Edge edge;
    detail::Kernel::Point_2 p, q;
  };

  static std::vector<Segment> segments_by_length(const detail::PlanarDelaunay& triangulation) {
    std::vector<Segment> segments;
    for (const auto& edge : triangulation.finite_edges()) {
      const auto& [face, i] = edge;
      segments.push_back({detail::edge_of(edge), face->vertex(triangulation.cw(i))->point(),
                          face->vertex(triangulation.ccw(i))->point()});
    }
    const auto compare = detail::Kernel().compare_distance_2_object();
    std::sort(segments.begin(), segments.end(), [&](const Segment& l, const Segment& r) {
      const auto order = compare(l.p, l.q, r.p, r.q);
      return order == CGAL::SMALLER || (order == CGAL::EQUAL && l.edge < r.edge);
    });
    return segments;
  }

  /// Which nodes are already connected.
  class Components {
   public:
    explicit Components(std::size_t num_nodes) : parent_(num_nodes) {
      std::iota(parent_.begin(), parent_.end(), std::size_t{0});
    }

    /// Connects two nodes; false if they already were.
    bool join(std::size_t i, std::size_t j) {
      i = root(i);
      j = root(j);
      parent_[j] = i;
      return i != j;
    }

   private:
    std::size_t root(std::size_t i) {
      while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
      return i;
    }

    std::vector<std::size_t> parent_;
  };
};

template <typename Projection>
MinimumSpanningTreeEdges(Projection) -> MinimumSpanningTreeEdges<Projection>;

}  // namespace v0
}  // namespace topobag
