// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <optional>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <topobag/matching/detail/normal_equations.hpp>
#include <topobag/matching/point_pair.hpp>
#include <topobag/matching/shared_vertical.hpp>

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

namespace detail {

template <typename Pairs>
NormalEquations<double> equations_at(const Eigen::Isometry3d& T_target_source, const Pairs& pairs,
                                     const RefineOptions& options,
                                     const std::optional<SharedVertical>& vertical) {
  NormalEquations<double> equations(T_target_source, pairs, options.kernel_width);
  if (vertical) equations.add_vertical(*vertical, T_target_source);
  return equations;
}

}  // namespace detail

/// Maximum-likelihood pose over all pairs, each weighted by its covariance, under a Geman–McClure
/// kernel (Gauss–Newton, iteratively re-weighted).
///
/// @param T_target_source  start, near the optimum
/// @param pairs            a range of `PointPair`, here and below
/// @param vertical         where both frames know it, here and below
/// Directions that the pairs leave open keep the start. O(iterations · n).
template <typename Pairs = std::vector<PointPair>>
Eigen::Isometry3d refined_motion(Eigen::Isometry3d T_target_source, const Pairs& pairs,
                                 const RefineOptions& options = {},
                                 const std::optional<SharedVertical>& vertical = std::nullopt) {
  for (int i = 0; i < options.iterations; ++i) {
    const auto step = detail::equations_at(T_target_source, pairs, options, vertical).solution();
    const double angle = step.rotation.norm();
    Eigen::Isometry3d move = Eigen::Isometry3d::Identity();
    if (angle > 0.0) {
      move.linear() = Eigen::AngleAxisd(angle, step.rotation / angle).toRotationMatrix();
    }
    move.translation() = step.translation;
    T_target_source = move * T_target_source;
    if (std::hypot(step.translation.norm(), angle) < options.tolerance) break;
  }
  T_target_source.linear() =
      Eigen::Quaterniond(T_target_source.linear()).normalized().toRotationMatrix();
  return T_target_source;
}

/// The covariance of a pose over these pairs: the inverse of their information. Directions that the
/// pairs leave open get a variance of 10⁶.
template <typename Pairs = std::vector<PointPair>>
Eigen::Matrix<double, 6, 6> pose_covariance(
    const Eigen::Isometry3d& T_target_source, const Pairs& pairs, const RefineOptions& options = {},
    const std::optional<SharedVertical>& vertical = std::nullopt) {
  return detail::equations_at(T_target_source, pairs, options, vertical).covariance();
}

/// The refined motion and its covariance.
template <typename Pairs = std::vector<PointPair>>
RefinedPose refine_pose(const Eigen::Isometry3d& T_target_source, const Pairs& pairs,
                        const RefineOptions& options = {},
                        const std::optional<SharedVertical>& vertical = std::nullopt) {
  const Eigen::Isometry3d refined = refined_motion(T_target_source, pairs, options, vertical);
  return {refined, pose_covariance(refined, pairs, options, vertical)};
}

}  // namespace v0
}  // namespace topobag
