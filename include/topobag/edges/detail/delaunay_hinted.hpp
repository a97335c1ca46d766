// SPDX-License-Identifier: MIT
#pragma once

// Includes CGAL's triangulations, which are GPL-3.0-or-later or under a commercial licence.

#include <type_traits>

#include <CGAL/Triangulation_hierarchy_2.h>
#include <CGAL/Triangulation_hierarchy_vertex_base_2.h>

#include <topobag/edges/detail/delaunay_planar.hpp>
#include <topobag/edges/hints.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

using HierarchyVertex = CGAL::Triangulation_hierarchy_vertex_base_2<PlanarVertex>;
using HierarchyDelaunay = CGAL::Triangulation_hierarchy_2<
    CGAL::Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<HierarchyVertex>>>;

/// CGAL's triangulation that serves a hint.
template <typename Hint>
using HintedDelaunay =
    std::conditional_t<std::is_same_v<Hint, HierarchyHint>, HierarchyDelaunay, PlanarDelaunay>;

}  // namespace detail
}  // namespace v0
}  // namespace topobag
