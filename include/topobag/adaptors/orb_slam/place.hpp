// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <set>
#include <vector>

#include <Eigen/Geometry>

#include <topobag/adaptors/orb_slam/host_maps.hpp>
#include <topobag/adaptors/orb_slam/host_pose.hpp>
#include <topobag/recognition/recognition.hpp>

namespace topobag {
inline namespace v0 {

/// A key frame of the host that the query resembles, and where the query's camera then is.
template <typename KeyFrame>
struct OrbSlamPlace {
  host_pointer_t<KeyFrame> key_frame{};  ///< the host's; a plain pointer owns nothing
  Eigen::Isometry3d T_candidate_query = Eigen::Isometry3d::Identity();  ///< the match
  /// The candidate's pose at the time of the query, carried on: in the candidate's world and unit.
  Eigen::Isometry3d T_world_query = Eigen::Isometry3d::Identity();
  /// How many of the candidate's units one of the query's is, where the options leave it open
  /// (`MatchOptions::scale`): a point p of the query's camera is at T_world_query · (scale · p).
  double scale = 1.0;
  double score = 0.0;        ///< `RelativePose::score()`
  bool verified = false;     ///< passed every stage of the decision, or was only not the best;
                             ///< otherwise a guess that the host has to test
  bool other_map = false;    ///< in another map than was asked for (hosts with several)
  bool by_bearings = false;  ///< found by directions alone, without depth

  /// The host's `mTcw` for the query: the candidate's world to the camera, in the candidate's unit.
  PlainPose camera_pose() const { return plain_pose(T_world_query.inverse()); }
};

namespace detail {

/// Every pose that a candidate offers. Precondition: the report has one.
/// @param map  places in another one are marked; null = whatever map
template <typename KeyFrame>
void append_places(const CandidateReport& report, const host_pointer_t<KeyFrame>& key_frame,
                   const void* map, std::vector<OrbSlamPlace<KeyFrame>>& places) {
  const Eigen::Isometry3d T_world_candidate =
      host_pose(host_traits<KeyFrame>::T_world_camera(*key_frame));
  const bool other_map = map != nullptr && map_of(*key_frame) != map;
  const auto offer = [&](const RelativePose& pose, bool verified) {
    places.push_back({key_frame, pose.T_candidate_query, T_world_candidate * pose.T_candidate_query,
                      pose.scale, pose.score(), verified, other_map});
  };
  offer(*report.pose, is_verified(report.verdict));
  for (const RelativePose& other : report.other_poses) offer(other, false);
}

/// Verified places first, then by falling score.
template <typename KeyFrame>
std::vector<OrbSlamPlace<KeyFrame>> best_first(const std::vector<OrbSlamPlace<KeyFrame>>& places) {
  std::vector<std::size_t> order(places.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  // By index: libstdc++'s stable_sort keeps places in a buffer that is not aligned for AVX.
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    const auto &l = places[a], &r = places[b];
    return l.verified != r.verified ? l.verified : l.score > r.score;
  });
  std::vector<OrbSlamPlace<KeyFrame>> sorted;
  for (const std::size_t i : order) sorted.push_back(places[i]);
  return sorted;
}

}  // namespace detail

/// The candidates to hand to the host: the verified places, then the host's own that are not bad,
/// then the guesses; each key frame once, where it comes first. Places were tested for bad key
/// frames when they were found.
template <typename KeyFrame>
std::vector<host_pointer_t<KeyFrame>> merge_candidates(
    const std::vector<OrbSlamPlace<KeyFrame>>& places,
    const std::vector<host_pointer_t<KeyFrame>>& of_the_host) {
  using Pointer = host_pointer_t<KeyFrame>;
  std::vector<Pointer> merged;
  std::set<const KeyFrame*> taken;
  const auto take = [&](const Pointer& key_frame) {
    if (taken.insert(&*key_frame).second) merged.push_back(key_frame);
  };
  for (const auto& place : places) {
    if (place.verified) take(place.key_frame);
  }
  for (const Pointer& key_frame : of_the_host) {
    if (key_frame != nullptr && !host_traits<KeyFrame>::is_bad(*key_frame)) take(key_frame);
  }
  for (const auto& place : places) take(place.key_frame);
  return merged;
}

}  // namespace v0
}  // namespace topobag
