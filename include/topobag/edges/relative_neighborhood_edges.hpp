// SPDX-License-Identifier: MIT
#pragma once

// Includes CGAL's triangulations, which are GPL-3.0-or-later or under a commercial licence.

#include <cstddef>
#include <limits>
#include <vector>

#include <topobag/edges/detail/bucket_sort.hpp>
#include <topobag/edges/detail/delaunay_planar.hpp>
#include <topobag/edges/edge_list.hpp>
#include <topobag/edges/projections.hpp>
#include <topobag/types/semantic_node.hpp>

namespace topobag {
inline namespace v0 {

/// Edge builder: the relative neighbourhood graph in a plane. Two nodes are joined when no third
/// node is strictly closer to both of them than they are to each other.
///
/// When: only pairs that belong together count, such as a keyboard and its mouse. About 1.2n
/// edges, connected, and few of them change when detections do.
///
/// The edges depend on distances alone, so a rotation changes nothing even on cocircular layouts
/// (as far as it is exact). Unique as `DelaunayEdges2`, with the same results for missing,
/// collinear and coincident nodes, and the same errors. A subset of `GabrielEdges`. Not regional:
/// a new node may cut the edge of a pair far apart. O(n log n) in general, O(n²) at worst.
template <typename Projection = ImagePlane>
struct RelativeNeighborhoodEdges {
  Projection projection{};  ///< nodes -> callable (node -> optional place in the plane)

  template <typename Scalar>
  EdgeList operator()(const std::vector<SemanticNode<Scalar>>& nodes) const {
    detail::PlanarDelaunay triangulation;
    EdgeList edges = detail::triangulate(triangulation, nodes, projection);
    LuneSearch lunes(triangulation, nodes.size());
    for (const auto& [face, i] : triangulation.finite_edges()) {
      const auto p = face->vertex(triangulation.cw(i));
      const auto q = face->vertex(triangulation.ccw(i));
      if (lunes.is_empty(p, q)) edges.push_back(make_edge(p->info(), q->info()));
    }
    detail::bucket_sort(edges, nodes.size());
    return edges;
  }

 private:
  using VertexHandle = detail::PlanarDelaunay::Vertex_handle;

  /// Looks for nodes strictly closer to p and to q than these are to each other. The vertices of a
  /// Delaunay triangulation inside a disc around one of them are connected inside that disc, so it
  /// is enough to spread from p.
  class LuneSearch {
   public:
    LuneSearch(const detail::PlanarDelaunay& triangulation, std::size_t num_nodes)
        : triangulation_(triangulation), reached_for_(num_nodes, 0) {}

    bool is_empty(VertexHandle p, VertexHandle q) {
      ++search_;
      reached_for_[value(p->info())] = search_;
      front_.assign(1, p);
      bool empty = true;
      while (empty && !front_.empty()) {
        const VertexHandle from = front_.back();
        front_.pop_back();
        detail::for_each_neighbor(triangulation_, from, [&](VertexHandle r) {
          std::size_t& reached_for = reached_for_[value(r->info())];
          if (reached_for == search_ || !is_closer(p, r, q)) return;
          reached_for = search_;
          front_.push_back(r);
          if (is_closer(q, r, p)) empty = false;
        });
      }
      return empty;
    }

   private:
    /// Whether `center` is strictly closer to `r` than to `other`.
    static bool is_closer(VertexHandle center, VertexHandle r, VertexHandle other) {
      return CGAL::compare_distance_to_point(center->point(), r->point(), other->point()) ==
             CGAL::SMALLER;
    }

    const detail::PlanarDelaunay& triangulation_;
    std::vector<std::size_t> reached_for_;  ///< by node: the last search that reached it
    std::vector<VertexHandle> front_;       ///< reached, its neighbours not yet looked at
    std::size_t search_ = 0;                ///< number of searches so far
  };
};

template <typename Projection>
RelativeNeighborhoodEdges(Projection) -> RelativeNeighborhoodEdges<Projection>;

}  // namespace v0
}  // namespace topobag
