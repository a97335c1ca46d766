// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <Eigen/Core>

#include <topobag/edges/delaunay_triangulation.hpp>

#include "edges/planar_layouts.hpp"

namespace layouts {

using Planar = topobag::DelaunayTriangulation<Eigen::Vector2d>;

/// The points of a layout, as `scaled` has them.
inline std::vector<Eigen::Vector2d> positions(const Layout& layout, int exponent = 0) {
  std::vector<Eigen::Vector2d> result;
  for (const Point& point : layout) result.push_back(scaled(point, exponent));
  return result;
}

}  // namespace layouts
