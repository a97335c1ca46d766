// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/Geometry>

#include <topobag/matching/point_pair.hpp>

namespace topobag {
inline namespace v0 {

/// A pose and how certain it is.
struct RefinedPose {
  Eigen::Isometry3d T_target_source;  ///< source to target
  /// Of ξ = (translation, rotation) in the target's frame, m and rad.
  Eigen::Matrix<double, 6, 6> covariance;
};

/// How far the refinement goes.
struct RefineOptions {
  int iterations = 5;         ///< Gauss-Newton steps at most
  double tolerance = 1e-4;    ///< m and rad; a shorter step is the last
  double kernel_width = 3.0;  ///< standard deviations at which the Geman–McClure kernel bends
};

/// Maximum-likelihood pose over all pairs, each weighted by its covariance, under a Geman–McClure
/// kernel (Gauss–Newton, iteratively re-weighted). Its covariance is the inverse of the information
/// at the optimum.
///
/// @param T_target_source  start, near the optimum
/// @param pairs            a range of `PointPair`
/// Directions that the pairs leave open keep the start and get a variance of 10⁶. O(iterations ·
/// n).
template <typename Pairs = std::vector<PointPair>>
RefinedPose refine_pose(Eigen::Isometry3d T_target_source, const Pairs& pairs,
                        const RefineOptions& options = {}) {
  using Matrix6 = Eigen::Matrix<double, 6, 6>;
  using Vector6 = Eigen::Matrix<double, 6, 1>;
  const double width2 = options.kernel_width * options.kernel_width;
  const auto normal_equations = [&](Matrix6& H, Vector6& g) {
    H = Matrix6::Identity() * 1e-6;
    g.setZero();
    for (const auto& pair : pairs) {
      const Eigen::Vector3d r = pair.residual(T_target_source);
      Eigen::Matrix3d weight = pair.covariance(T_target_source).inverse();
      const double bent = 1.0 + r.dot(weight * r) / width2;
      weight /= bent * bent;
      // The moved source point changes by (I, turn) · ξ.
      const Eigen::Vector3d moved = T_target_source * pair.source;
      Eigen::Matrix3d turn;
      turn << 0.0, moved.z(), -moved.y(), -moved.z(), 0.0, moved.x(), moved.y(), -moved.x(), 0.0;
      const Eigen::Matrix3d weighted_turn = weight * turn;
      H.topLeftCorner<3, 3>() += weight;
      H.topRightCorner<3, 3>() += weighted_turn;
      H.bottomRightCorner<3, 3>() += turn.transpose() * weighted_turn;
      g.head<3>() += weight * r;
      g.tail<3>() += weighted_turn.transpose() * r;
    }
    H.bottomLeftCorner<3, 3>() = H.topRightCorner<3, 3>().transpose();
  };
  Matrix6 H;
  Vector6 g;
  for (int i = 0; i < options.iterations; ++i) {
    normal_equations(H, g);
    const Vector6 step = H.llt().solve(g);
    const Eigen::Vector3d turn = step.tail<3>();
    const double angle = turn.norm();
    Eigen::Isometry3d move = Eigen::Isometry3d::Identity();
    if (angle > 0.0) move.linear() = Eigen::AngleAxisd(angle, turn / angle).toRotationMatrix();
    move.translation() = step.head<3>();
    T_target_source = move * T_target_source;
    if (step.norm() < options.tolerance) break;
  }
  normal_equations(H, g);
  T_target_source.linear() =
      Eigen::Quaterniond(T_target_source.linear()).normalized().toRotationMatrix();
  return {T_target_source, H.llt().solve(Matrix6::Identity())};
}

}  // namespace v0
}  // namespace topobag
