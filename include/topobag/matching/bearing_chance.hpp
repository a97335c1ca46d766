// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <Eigen/LU>

#include <topobag/matching/refine_pose.hpp>
#include <topobag/matching/shared_vertical.hpp>
#include <topobag/types/detail/cholesky.hpp>

namespace topobag {
inline namespace v0 {

/// A bearing and the object of a map that it may be of, under a pose.
struct BearingPair {
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();      ///< unit vector in the camera's frame
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Identity();  ///< rad², of the two angles between
                                                             ///< the bearing and the object
  double squared_deviation = 0.0;      ///< of these angles: χ² with two degrees of freedom
  std::optional<double> size_ratio{};  ///< ln of the depth that the sizes tell over the pose's;
                                       ///< nothing where a size is not known
  std::size_t choices = 1;             ///< objects of its class that the camera has in view there
};

/// How surprising it is that bearings point at a map's objects.
///
/// As `ChanceModel`, an a-contrario bound: the inverse Bayes factor of two models of the query. In
/// one, a bearing is of any of the objects of its class that the camera has in view, each as
/// likely, within the noise of both, or of none that the map holds; the pose is integrated out
/// (Laplace). In the other, chance strews the bearings over the rectangle that they fill in the
/// image: that one falls into a gate of solid angle Ω has the probability Ω / rectangle. However
/// many hypotheses were tried, all are in the integral: a bearing pays for its object with the
/// number of those that it might have been of, and one that is of none pays, too. Of three bearings
/// and a pose nothing remains but their apparent sizes; each further one is worth what two angles
/// are. A place in space is worth three lengths: bearings cost significance.
///
/// The pose's prior: mostly near the candidate's camera, as who comes back is (`near_share`), else
/// anywhere in a room, turned any way, or level where the vertical is known. An apparent size is
/// news as far as chance would vary it more than the noise does.
struct BearingChance {
  double fill = 1.5;              ///< solid angle that chance fills, in rectangles of the bearings
  double min_extent = 0.2;        ///< rad, of each of the rectangle's sides
  double unmapped = 0.3;          ///< share of the bearings whose objects the map does not hold
  double camera_volume = 30.0;    ///< m³ of a room, in which the camera may be
  double near_share = 0.7;        ///< of the revisits whose camera is near the candidate's
  double near_deviation = 0.6;    ///< m, of these along each axis
  double size_deviation = 0.15;   ///< of ln of the apparent size of one object, seen twice
  double chance_deviation = 0.5;  ///< the same of two objects of a class
  double size_outliers = 0.2;     ///< share of the sizes that tell nothing: misread boxes

  /// log10 P(bearings, sizes | same place, pose unknown) / P(bearings, sizes | chance). O(n).
  /// @param pairs     a range of `BearingPair` at `pose`, at least three
  /// @param unmatched  bearings that are in no pair, while the camera has such objects in view
  /// @param pose      T_target_source of the camera in the map's frame, and its covariance
  /// @param vertical  where both frames know it
  template <typename Pairs>
  double log10_bayes_factor(const Pairs& pairs, std::size_t unmatched, const RefinedPose& pose,
                            const std::optional<SharedVertical>& vertical = std::nullopt) const {
    const double log_two_pi = 1.8378770664093453;
    const double log_area = std::log(solid_angle(pairs));
    double log_factor = static_cast<double>(unmatched) * std::log(unmapped);
    for (const BearingPair& pair : pairs) {
      log_factor +=
          std::log((1.0 - unmapped) / static_cast<double>(std::max<std::size_t>(pair.choices, 1)));
      log_factor += log_area - log_two_pi -
                    0.5 * (pair.squared_deviation + std::log(pair.covariance.determinant()));
      if (pair.size_ratio) log_factor += log_size_factor(*pair.size_ratio);
    }
    const double turns2 =
        pose.T_target_source.translation().squaredNorm() / (near_deviation * near_deviation);
    const double near_volume = std::pow(near_deviation, 3) * std::exp(1.5 * log_two_pi);
    double log_prior = std::log(near_share * std::exp(-0.5 * turns2) / near_volume +
                                (1.0 - near_share) / camera_volume);
    if (vertical) {
      const Eigen::Vector3d tilt = vertical->tilt(pose.T_target_source.linear());
      log_prior -= 2.0 * log_two_pi + std::log(vertical->variance) +
                   0.5 * tilt.squaredNorm() / vertical->variance;
    } else {
      log_prior -= 2.0 * log_two_pi + std::log(2.0);  // 8 π², the volume of SO(3)
    }
    const double log_posterior_volume =
        3.0 * log_two_pi + detail::log_root_determinant(pose.covariance);
    return (log_factor + log_prior + log_posterior_volume) / std::log(10.0);
  }

  /// ln P(ratio | one object) / P(ratio | chance), of which the greatest density is taken.
  double log_size_factor(double ratio) const {
    const double turns = ratio / size_deviation;
    const double factor = chance_deviation / size_deviation * std::exp(-0.5 * turns * turns);
    return std::log(size_outliers + (1.0 - size_outliers) * factor);
  }

  /// Of the rectangle over which chance strews bearings, sr.
  template <typename Pairs>
  double solid_angle(const Pairs& pairs) const {
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (const BearingPair& pair : pairs) middle += pair.direction;
    middle.normalize();
    const Eigen::Vector3d across = middle.unitOrthogonal(), along = middle.cross(across);
    const auto n = static_cast<double>(pairs.size());
    Eigen::Vector2d mean = Eigen::Vector2d::Zero();
    Eigen::Matrix2d scatter = Eigen::Matrix2d::Zero();
    for (const BearingPair& pair : pairs) {
      const Eigen::Vector2d at(across.dot(pair.direction), along.dot(pair.direction));
      mean += at / n;
      scatter += at * at.transpose() / n;
    }
    scatter -= mean * mean.transpose();
    const double half_trace = 0.5 * scatter.trace();
    const double root = std::sqrt(std::max(0.0, half_trace * half_trace - scatter.determinant()));
    const auto side = [&](double variance) {
      return std::max(min_extent, std::sqrt(12.0 * std::max(0.0, variance)));
    };
    return fill * side(half_trace + root) * side(half_trace - root);
  }
};

}  // namespace v0
}  // namespace topobag
