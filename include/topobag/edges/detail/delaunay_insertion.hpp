// SPDX-License-Identifier: MIT
#pragma once

// Includes CGAL's triangulations, which are GPL-3.0-or-later or under a commercial licence.

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Spatial_sort_traits_adapter_2.h>
#include <CGAL/Spatial_sort_traits_adapter_3.h>
#include <CGAL/property_map.h>
#include <CGAL/spatial_sort.h>

#include <topobag/edges/edge_list.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// Exact predicates on double coordinates.
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

template <typename Point>
using IndexedPoint = std::pair<Point, NodeIndex>;

template <typename Point>
inline constexpr bool is_planar_v = std::is_same_v<Point, Kernel::Point_2>;

/// Reorders points so that successive ones lie close together. Deterministic. O(n log n).
template <typename Point>
void sort_spatially(std::vector<IndexedPoint<Point>>& points) {
  using PointOf = CGAL::First_of_pair_property_map<IndexedPoint<Point>>;
  using Traits =
      std::conditional_t<is_planar_v<Point>, CGAL::Spatial_sort_traits_adapter_2<Kernel, PointOf>,
                         CGAL::Spatial_sort_traits_adapter_3<Kernel, PointOf>>;
  CGAL::spatial_sort(points.begin(), points.end(), Traits());
}

/// Inserts the points into an empty triangulation; each vertex carries its point's index as info,
/// of coincident points the smallest. Returns an edge from that smallest index to each of the
/// others, in no particular order. May reorder the points.
template <typename Triangulation, typename Point>
EdgeList insert_points(Triangulation& triangulation, std::vector<IndexedPoint<Point>>& points) {
  constexpr std::size_t sorting_pays = 200;  // measured: below, sorting costs more than it saves
  if (points.size() >= sorting_pays) sort_spatially(points);

  using VertexHandle = typename Triangulation::Vertex_handle;
  const auto insert = [&](const Point& point, VertexHandle near) -> VertexHandle {
    if (near == VertexHandle()) return triangulation.insert(point);
    if constexpr (is_planar_v<Point>) return triangulation.insert(point, near->face());
    if constexpr (!is_planar_v<Point>) return triangulation.insert(point, near->cell());
  };

  std::vector<std::pair<VertexHandle, NodeIndex>> lost;
  VertexHandle last;
  for (const auto& [point, index] : points) {
    const auto known = triangulation.number_of_vertices();
    last = insert(point, last);
    if (triangulation.number_of_vertices() == known) {
      const NodeIndex present = last->info();
      lost.emplace_back(last, std::max(present, index));
      last->info() = std::min(present, index);
    } else {
      last->info() = index;
    }
  }
  EdgeList twins;
  twins.reserve(lost.size());
  for (const auto& [kept, index] : lost) twins.push_back({kept->info(), index});
  return twins;
}

}  // namespace detail
}  // namespace v0
}  // namespace topobag
