// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <topobag/evaluation/trajectory.hpp>

namespace topobag {
inline namespace v0 {

/// An estimated pose beside the true one of the same moment.
struct PosePair {
  double stamp = 0.0;                                           ///< of the estimate, s
  Eigen::Isometry3d T_true{Eigen::Isometry3d::Identity()};      ///< body to the truth's world
  Eigen::Isometry3d T_estimate{Eigen::Isometry3d::Identity()};  ///< body to the estimate's world
};

/// Pairs every estimate with the ground truth interpolated at its stamp, where both neighbours of
/// the ground truth are less than `max_gap_s` away; other estimates have no pair. O(m log n).
/// @param groundtruth,estimate  each a `Trajectory`, or other sorted `StampedPose`, random access
template <typename TruePoses = Trajectory, typename EstimatedPoses = Trajectory>
std::vector<PosePair> associate(const TruePoses& groundtruth, const EstimatedPoses& estimate,
                                double max_gap_s = 0.5,
                                RotationInterpolation rule = RotationInterpolation::slerp) {
  std::vector<PosePair> pairs;
  pairs.reserve(estimate.size());
  for (const auto& pose : estimate) {
    if (const auto truth = pose_at(groundtruth, pose.stamp, max_gap_s, rule)) {
      pairs.push_back({pose.stamp, *truth, pose.T_world_body});
    }
  }
  return pairs;
}

}  // namespace v0
}  // namespace topobag
