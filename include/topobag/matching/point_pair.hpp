// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <Eigen/LU>

#include <topobag/sensing/node_noise.hpp>
#include <topobag/types/semantic_node.hpp>

namespace topobag {
inline namespace v0 {

/// Two measurements of one object's position and the covariance of each, m and m².
struct PointPair {
  Eigen::Vector3d target;             ///< m, target frame
  Eigen::Vector3d source;             ///< m, source frame
  Eigen::Matrix3d target_covariance;  ///< m², target frame
  Eigen::Matrix3d source_covariance;  ///< m², source frame

  /// Target less moved source, m.
  /// @param T_target_source  an `Eigen::Isometry3d`, here and below
  template <typename Pose>
  Eigen::Vector3d residual(const Pose& T_target_source) const {
    return target - T_target_source * source;
  }

  /// Of the residual.
  template <typename Pose>
  Eigen::Matrix3d covariance(const Pose& T_target_source) const {
    const Eigen::Matrix3d R = T_target_source.linear();
    return target_covariance + R * source_covariance * R.transpose();
  }

  /// Squared Mahalanobis length of the residual: χ² with three degrees of freedom for a true pair.
  template <typename Pose>
  double squared_deviation(const Pose& T_target_source) const {
    const Eigen::Vector3d r = residual(T_target_source);
    return r.dot(covariance(T_target_source).inverse() * r);
  }
};

/// Two nodes taken for the same object. Precondition: both have a position.
template <typename Scalar>
PointPair point_pair(const SemanticNode<Scalar>& target, const SemanticNode<Scalar>& source) {
  return {target.position->template cast<double>(), source.position->template cast<double>(),
          position_covariance(target), position_covariance(source)};
}

}  // namespace v0
}  // namespace topobag
