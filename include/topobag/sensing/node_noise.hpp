// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>

#include <Eigen/Core>

#include <topobag/types/semantic_node.hpp>

namespace topobag {
inline namespace v0 {

/// How far a node's measured position lies from where the object's centre is, as one standard
/// deviation.
///
/// Along the viewing ray: the sensor's depth noise, which grows with z², and the depth of the
/// object itself, of which only the front is seen. Across it: the jitter of the detector's box. A
/// box cut by the image border shows part of the object, so its centre is off by a share of the
/// object's size.
struct NodeNoise {
  double depth_floor = 0.01;       ///< m
  double depth_quadratic = 0.005;  ///< m at 1 m; grows with z²
  double depth_of_object = 0.10;   ///< share of the object's size
  double box_jitter = 0.06;        ///< share of the object's size
  double box_floor = 0.01;         ///< m
  double truncation = 0.15;        ///< share of the object's size, across the ray, for a cut box

  /// Covariance (3 × 3, m²) of a position in the camera frame.
  /// @param position   m, camera frame, not the origin
  /// @param size       extent parallel to the image, m: two numbers of any Eigen expression
  /// @param truncated  whether the box touches the image border
  template <typename Size = Eigen::Vector2d>
  Eigen::Matrix3d covariance(const Eigen::Vector3d& position, const Size& size,
                             bool truncated) const {
    const double extent = std::sqrt(std::max(0.0, size.x() * size.y()));
    const double z2 = position.z() * position.z();
    const double along2 =
        square(depth_floor) + square(depth_quadratic * z2) + square(depth_of_object * extent);
    const double across2 = square(box_floor) + square(box_jitter * extent) +
                           (truncated ? square(truncation * extent) : 0.0);
    const Eigen::Vector3d ray = position.normalized();
    // A product of its own, for Eigen would scale one factor first and lose the symmetry.
    const Eigen::Matrix3d projection = ray * ray.transpose();
    return across2 * Eigen::Matrix3d::Identity() + (along2 - across2) * projection;
  }

 private:
  static double square(double x) { return x * x; }
};

/// The covariance of a node's position, m²: its own, or `unmodelled`'s where it has none (zero).
/// Precondition: the node has a position.
template <typename Scalar>
Eigen::Matrix3d position_covariance(const SemanticNode<Scalar>& node,
                                    const NodeNoise& unmodelled = {}) {
  if (!node.covariance.isZero(Scalar(0))) return node.covariance.template cast<double>();
  return unmodelled.covariance(node.position->template cast<double>(),
                               node.size.template cast<double>(), false);
}

}  // namespace v0
}  // namespace topobag
