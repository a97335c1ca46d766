// SPDX-License-Identifier: MIT
#pragma once

/// The whole library: `core.hpp` and the Delaunay edge builders over CGAL, whose triangulation
/// headers are under GPL-3.0-or-later or a commercial licence. Target `topobag::topobag`.
#include <topobag/core.hpp>
#include <topobag/edges/delaunay_edges2.hpp>
#include <topobag/edges/delaunay_edges3.hpp>
#include <topobag/edges/delaunay_triangulation.hpp>
#include <topobag/edges/gabriel_edges.hpp>
#include <topobag/edges/minimum_spanning_tree_edges.hpp>
#include <topobag/edges/relative_neighborhood_edges.hpp>
