// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include <topobag/sensing/depth_sampling.hpp>
#include <topobag/types/bounding_box.hpp>

namespace topobag {
inline namespace v0 {

/// A SLAM system's point as an image shows it.
struct DepthPoint {
  Eigen::Vector2d pixel = Eigen::Vector2d::Zero();  ///< px
  double z = 0.0;                                   ///< along the optical axis, m
};

/// A depth source over a SLAM system's sparse points, for monocular and stereo hosts: the depth of
/// the nearest point. Points that are not finite or not before the camera are left out.
class SparseDepth {
 public:
  /// @param radius  px within which a point tells a pixel's depth
  explicit SparseDepth(const std::vector<DepthPoint>& points, double radius = 5.0)
      : radius_(radius) {
    for (const DepthPoint& point : points) {
      if (point.pixel.allFinite() && std::isfinite(point.z) && point.z > 0.0) {
        points_.push_back(point);
      }
    }
  }

  /// Those that were kept, in the order given.
  const std::vector<DepthPoint>& points() const noexcept { return points_; }

  /// Ties go to the earlier point. O(points).
  std::optional<double> operator()(const Eigen::Vector2d& pixel) const {
    std::optional<double> z;
    double nearest2 = radius_ * radius_;
    for (const DepthPoint& point : points_) {
      const double distance2 = (point.pixel - pixel).squaredNorm();
      if (!(z ? distance2 < nearest2 : distance2 <= nearest2)) continue;  // NaN goes here, too
      nearest2 = distance2;
      z = point.z;
    }
    return z;
  }

 private:
  std::vector<DepthPoint> points_;
  double radius_;
};

/// The sampling policy that goes with sparse points: the median of the nearest dense cluster of the
/// points inside the box. O(points + k log k) for k points in the box.
struct SparseBoxDepth {
  double central_share = 0.8;  ///< share of the box's width and height whose points count
  std::size_t min_points = 3;  ///< with fewer there is no depth; >= 1
  double cluster_width = 0.1;  ///< a cluster spans this share of its depth, and at least 5 cm
  double min_cluster_share =
      0.5;  ///< nearest cluster with this share (0 to 1) of the largest one's points wins

  std::optional<double> operator()(const SparseDepth& depth, const BoundingBox& box) const {
    const BoundingBox middle =
        box_around(box.center(), box.width() * central_share, box.height() * central_share);
    std::vector<double> depths;
    for (const DepthPoint& point : depth.points()) {
      if (middle.contains(point.pixel)) depths.push_back(point.z);
    }
    if (depths.empty() || depths.size() < min_points) return std::nullopt;
    std::sort(depths.begin(), depths.end());
    return detail::nearest_cluster(depths, cluster_width, min_cluster_share);
  }
};

}  // namespace v0
}  // namespace topobag
