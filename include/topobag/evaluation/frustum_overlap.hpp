// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include <topobag/error.hpp>
#include <topobag/sensing/pinhole_camera.hpp>

namespace topobag {
inline namespace v0 {

/// The part of space that a depth camera sees.
struct DepthFrustum {
  PinholeCamera<double> camera;  ///< with its image size
  double near_m = 0.4;           ///< nearest depth Z, m, > 0
  double far_m = 4.0;            ///< farthest depth Z, m

  /// Throws InvalidValue.
  void validate() const {
    camera.validate();
    if (camera.width <= 0 || camera.height <= 0) {
      throw InvalidValue("a frustum needs the size of the image");
    }
    if (!(near_m > 0.0 && far_m > near_m && std::isfinite(far_m))) {
      throw InvalidValue("a frustum needs depths 0 < near < far, finite");
    }
  }
};

namespace detail {

inline constexpr int frustum_grid = 8;  // samples along u, v and depth

/// The share of a's sample points that b sees.
template <typename Pose>
double seen_share(const DepthFrustum& frustum, const Pose& T_b_a) {
  int seen = 0;
  for (int k = 0; k < frustum_grid; ++k) {
    const auto centre = [](int i) { return (i + 0.5) / frustum_grid; };
    const double z = frustum.near_m + centre(k) * (frustum.far_m - frustum.near_m);
    for (int i = 0; i < frustum_grid; ++i) {
      for (int j = 0; j < frustum_grid; ++j) {
        const Eigen::Vector2d pixel(centre(i) * frustum.camera.width - 0.5,
                                    centre(j) * frustum.camera.height - 0.5);
        const Eigen::Vector3d point = T_b_a * frustum.camera.back_project(pixel, z);
        if (point.z() < frustum.near_m || point.z() > frustum.far_m) continue;
        const auto in_b = frustum.camera.project(point);
        if (in_b && frustum.camera.in_image(*in_b)) ++seen;
      }
    }
  }
  return static_cast<double>(seen) / (frustum_grid * frustum_grid * frustum_grid);
}

}  // namespace detail

/// Covisibility of two equal depth cameras, in [0, 1]: the share of the points of a regular grid
/// over one frustum (8 × 8 pixels × 8 depths) that lies in the other, the smaller of both ways.
/// Walls are not known and hide nothing. Symmetric; O(1).
/// @param T_a_b  an `Eigen::Isometry3d`
template <typename Pose>
double frustum_overlap(const DepthFrustum& frustum, const Pose& T_a_b) {
  const PinholeCamera<double>& camera = frustum.camera;
  const auto reach = [&](double u, double v) {
    return camera.back_project(Eigen::Vector2d(u, v), frustum.far_m).norm();
  };
  const double w = camera.width;
  const double h = camera.height;
  const double radius = std::max({reach(0, 0), reach(w, 0), reach(0, h), reach(w, h)});
  if (T_a_b.translation().norm() > 2.0 * radius) return 0.0;
  const double a_in_b = detail::seen_share(frustum, T_a_b.inverse(Eigen::Isometry));
  return std::min(a_in_b, detail::seen_share(frustum, T_a_b));
}

}  // namespace v0
}  // namespace topobag
