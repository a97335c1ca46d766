// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <topobag/types/detail/one_alignment.hpp>
#include <topobag/version.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// The flat box in which matched objects lie: things stand on floors and tables, next to each
/// other.
struct Slab {
  Eigen::Vector3d normal;  ///< unit vector across the slab: the vertical, or the thinnest direction
  double length = 0.0;     ///< m, the longer side of the uniform rectangle of the same scatter
  double width = 0.0;      ///< m, the shorter one
  double tilt_information = 0.0;  ///< root of the determinant of the scatter along the slab, m²

  /// Of the targets of pairs. @param points  a range of `PointPair`
  /// @param vertical  a pointer to a `SharedVertical`; null where it is not known
  template <typename Points, typename Vertical,
            typename Solver = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>>
  Slab(const Points& points, const Vertical* vertical) {
    const auto n = static_cast<double>(points.size());
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (const auto& pair : points) mean += pair.target / n;
    Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
    for (const auto& pair : points) {
      scatter += (pair.target - mean) * (pair.target - mean).transpose() / n;
    }
    if (vertical) {
      normal = vertical->target_down;
    } else {
      Solver axes;
      axes.computeDirect(scatter);
      normal = axes.eigenvectors().col(0);
    }
    const Eigen::Matrix3d along = Eigen::Matrix3d::Identity() - normal * normal.transpose();
    const Eigen::Matrix3d flat = along * scatter * along;
    // The two variances along the slab: half the trace, more or less a root.
    const double half_trace = 0.5 * flat.trace();
    const double determinant =
        std::max(0.0, 2.0 * half_trace * half_trace - 0.5 * (flat * flat).trace());
    const double root = std::sqrt(std::max(0.0, half_trace * half_trace - determinant));
    length = std::sqrt(12.0 * (half_trace + root));
    width = std::sqrt(12.0 * std::max(0.0, half_trace - root));
    tilt_information = std::sqrt(determinant);
  }
};

}  // namespace detail
}  // namespace v0
}  // namespace topobag
