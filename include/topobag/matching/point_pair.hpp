// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <Eigen/LU>

#include <topobag/sensing/node_noise.hpp>
#include <topobag/types/semantic_node.hpp>

namespace topobag {
inline namespace v0 {

/// Two measurements of one object's position and the covariance of each, m and m².
///
/// One sees an object's front, so what is measured lies before its centre by a share of its depth.
/// From one side both measurements are off alike, and the residual knows nothing of it. The further
/// the pose turns the view, the more of it stays in the residual: the front's along the chord
/// between the two viewing rays, and in every direction the outline's, whose middle wanders with
/// the view of whatever is no ball.
struct PointPair {
  /// How far the front lies before the centre, as one standard deviation: share of the object's
  /// size. A box seen at its nearest face is at 0.5, a ranged middle of it at 0.25, a thing
  /// triangulated from many sides at 0.
  static constexpr double front_share = 0.25;
  /// How far the outline's middle lies from the centre, likewise, along each axis.
  static constexpr double outline_share = 0.05;

  Eigen::Vector3d target;             ///< m, target frame
  Eigen::Vector3d source;             ///< m, source frame
  Eigen::Matrix3d target_covariance;  ///< m², target frame
  Eigen::Matrix3d source_covariance;  ///< m², source frame
  /// Viewing rays towards the object, of the length of its size, m; zero: a point without a size.
  Eigen::Vector3d target_view = Eigen::Vector3d::Zero();
  Eigen::Vector3d source_view = Eigen::Vector3d::Zero();  ///< in the source frame

  /// Target less moved source, m.
  /// @param T_target_source  an `Eigen::Isometry3d`, here and below
  template <typename Pose>
  Eigen::Vector3d residual(const Pose& T_target_source) const {
    return target - T_target_source * source;
  }

  /// Of the residual, m²: what both measurements add to it, and what the turn of the view does,
  /// which is zero for none and greatest for opposite views. Positive definite.
  template <typename Pose>
  Eigen::Matrix3d covariance(const Pose& T_target_source) const {
    const Eigen::Matrix3d R = T_target_source.linear();
    const Eigen::Vector3d chord = target_view - R * source_view;
    const Eigen::Vector3d front = front_share * chord;
    const double outline2 = outline_share * outline_share * chord.squaredNorm();
    Eigen::Matrix3d sum = target_covariance + R * source_covariance * R.transpose();
    sum.noalias() += front * front.transpose();
    sum.diagonal().array() += outline2;
    return sum;
  }

  /// Of the residual in any direction and under any pose, m²: no more than this.
  double max_variance() const {
    const double chord = target_view.norm() + source_view.norm();
    const double share2 = front_share * front_share + 3.0 * outline_share * outline_share;
    return target_covariance.trace() + source_covariance.trace() + share2 * chord * chord;
  }

  /// The same pair as if both had seen the object from one side: its covariance is that of the
  /// measurements alone, whatever the pose.
  PointPair seen_alike() const { return {target, source, target_covariance, source_covariance}; }

  /// Squared Mahalanobis length of the residual: χ² with three degrees of freedom for a true pair.
  template <typename Pose>
  double squared_deviation(const Pose& T_target_source) const {
    const Eigen::Vector3d r = residual(T_target_source);
    return r.dot(covariance(T_target_source).inverse() * r);
  }
};

/// Two nodes taken for the same object, whose size is the geometric mean of what both show. A
/// node's viewing ray is taken to be that of its graph's camera. Precondition: both have a
/// position.
/// @param unmodelled  the noise of a node that has no covariance
template <typename Scalar>
PointPair point_pair(const SemanticNode<Scalar>& target, const SemanticNode<Scalar>& source,
                     const NodeNoise& unmodelled = {}) {
  const double there2 = static_cast<double>(target.size.x() * target.size.y());
  const double here2 = static_cast<double>(source.size.x() * source.size.y());
  const double size = std::sqrt(std::sqrt(std::max(0.0, there2 * here2)));
  const Eigen::Vector3d there = target.position->template cast<double>();
  const Eigen::Vector3d here = source.position->template cast<double>();
  return {there,
          here,
          position_covariance(target, unmodelled),
          position_covariance(source, unmodelled),
          size * there.normalized(),
          size * here.normalized()};
}

}  // namespace v0
}  // namespace topobag
