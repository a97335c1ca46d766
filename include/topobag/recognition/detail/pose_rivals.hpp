// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/Geometry>

#include <topobag/matching/relative_pose.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// Whether `pose` lies within the 95 % region of a pose that the matched objects leave open.
template <typename Pose>
bool within_uncertainty(const Pose& open, const Pose& pose) {
  const double chi2_95 = 12.5916;  // of six degrees of freedom
  const Eigen::Isometry3d between = pose.T_candidate_query * open.T_candidate_query.inverse();
  const Eigen::AngleAxisd turn(between.linear());
  Eigen::Matrix<double, 6, 1> xi;
  xi << between.translation(), turn.angle() * turn.axis();
  return xi.dot((open.covariance + pose.covariance).ldlt().solve(xi)) <= chi2_95;
}

/// Whether another pose of the candidate keeps `pose` from being believed: it fits about as well. A
/// degenerate pose is no answer itself, but says that the answer is elsewhere if it fits better and
/// does not leave `pose` open.
template <typename Pose>
bool is_rival(const Pose& other, const Pose& pose, double min_lead) {
  if (!other.degenerate) return other.support() > pose.support() - min_lead;
  return other.score() > pose.score() && !within_uncertainty(other, pose);
}

}  // namespace detail
}  // namespace v0
}  // namespace topobag
