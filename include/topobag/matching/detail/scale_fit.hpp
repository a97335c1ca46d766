// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <Eigen/LU>

#include <topobag/matching/refine_pose.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// What pairs of points say of the logarithm of the source's scale beside a pose, by the normal
/// equations of all seven unknowns.
struct ScaleFit {
  double step = 0.0;      ///< to its optimum
  double variance = 0.0;  ///< with the pose unknown as well
  /// How the pose's optimum, (translation, rotation) in the target's frame, goes with it.
  Eigen::Matrix<double, 6, 1> lever = Eigen::Matrix<double, 6, 1>::Zero();

  /// @param T_target_source  the optimum at the source's present scale
  /// @param covariance       of it, over the same pairs
  /// @param pairs            a range of `PointPair`
  template <typename Pairs>
  ScaleFit(const Eigen::Isometry3d& T_target_source, const Eigen::Matrix<double, 6, 6>& covariance,
           const Pairs& pairs, const RefineOptions& options) {
    const double width2 = options.kernel_width * options.kernel_width;
    Eigen::Matrix<double, 6, 1> mixed = Eigen::Matrix<double, 6, 1>::Zero();
    double information = 1e-6, pull = 0.0;  // of a scale that no pair pins down
    for (const auto& pair : pairs) {
      const Eigen::Vector3d moved = T_target_source * pair.source;
      const Eigen::Vector3d r = pair.target - moved;
      const Eigen::Matrix3d inverse = pair.covariance(T_target_source).inverse();
      const double bent = width2 / (width2 + r.dot(inverse * r));
      const Eigen::Vector3d ray = moved - T_target_source.translation();
      const Eigen::Vector3d weighted = bent * bent * (inverse * ray);
      information += ray.dot(weighted);
      pull += r.dot(weighted);
      mixed.head<3>() += weighted;
      mixed.tail<3>() += moved.cross(weighted);
    }
    lever = -covariance * mixed;
    // Rounding may leave less than nothing where the objects hardly differ in place.
    const double left = information + mixed.dot(lever);
    variance = left > 1e-6 ? 1.0 / left : 1e6;
    step = variance * pull;
  }
};

}  // namespace detail
}  // namespace v0
}  // namespace topobag
