// SPDX-License-Identifier: MIT
#pragma once

#include <set>
#include <vector>

#include <Eigen/Geometry>

#include <topobag/adaptors/orb_slam/host_pose.hpp>

namespace topobag {
inline namespace v0 {

/// A key frame of the host that the query resembles, and where the query's camera then is.
template <typename KeyFrame>
struct OrbSlamPlace {
  KeyFrame* key_frame = nullptr;                                        ///< the host's; not owned
  Eigen::Isometry3d T_candidate_query = Eigen::Isometry3d::Identity();  ///< the match
  /// The candidate's pose at the time of the query, carried on.
  Eigen::Isometry3d T_world_query = Eigen::Isometry3d::Identity();
  double score = 0.0;      ///< `RelativePose::score()`
  bool verified = false;   ///< passed every stage of the decision, or was only outdone; otherwise a
                           ///< guess that the host has to test
  bool other_map = false;  ///< in another map than was asked for (hosts with several)

  /// The host's `mTcw` for the query: world to camera.
  PlainPose camera_pose() const { return plain_pose(T_world_query.inverse()); }
};

/// The candidates to hand to the host: the verified places, then the host's own that are not bad,
/// then the guesses; each key frame once, where it comes first. Places were tested for bad key
/// frames when they were found.
template <typename KeyFrame>
std::vector<KeyFrame*> merge_candidates(const std::vector<OrbSlamPlace<KeyFrame>>& places,
                                        const std::vector<KeyFrame*>& of_the_host) {
  std::vector<KeyFrame*> merged;
  std::set<const KeyFrame*> taken;
  const auto take = [&](KeyFrame* key_frame) {
    if (taken.insert(key_frame).second) merged.push_back(key_frame);
  };
  for (const auto& place : places) {
    if (place.verified) take(place.key_frame);
  }
  for (KeyFrame* key_frame : of_the_host) {
    if (key_frame != nullptr && !key_frame->isBad()) take(key_frame);
  }
  for (const auto& place : places) take(place.key_frame);
  return merged;
}

}  // namespace v0
}  // namespace topobag
