// SPDX-License-Identifier: MIT
// Tests where a key frame is in another map, by the pose of the objects and the host's own means;
// included by the host's LoopClosing.cc.
#pragma once

#include <cstddef>
#include <set>
#include <vector>

#include "RelocalizeFromPlaces.h"

namespace topobag_hooks {

/// The place's world, in its unit, to the key frame, in the key frame's own.
inline g2o::Sim3 SimilarityOf(const Place<ORB_SLAM3::KeyFrame>& place, bool fixed_scale) {
  const Sophus::SE3d Tcw = PoseOf(place).cast<double>();
  const double scale = fixed_scale ? 1.0 : 1.0 / static_cast<double>(place.scale);
  const Eigen::Vector3d translation = scale * Tcw.translation();
  return g2o::Sim3(Tcw.unit_quaternion(), translation, scale);
}

/// Refines the object pose (`Scw`: the place's world to the key frame) by matches of the map points
/// around the place, in searches that narrow. False where there are too few.
inline bool RefineSim3(const Place<ORB_SLAM3::KeyFrame>& place, ORB_SLAM3::KeyFrame* key_frame,
                       bool fixed_scale, g2o::Sim3& Scw) {
  std::set<ORB_SLAM3::MapPoint*> known;
  for (ORB_SLAM3::KeyFrame* other : PlaceSearch<OrbSlam3>::Around(place.key_frame)) {
    for (ORB_SLAM3::MapPoint* point : other->GetMapPointMatches()) {
      if (point && !point->isBad()) known.insert(point);
    }
  }
  const std::vector<ORB_SLAM3::MapPoint*> points(known.begin(), known.end());
  const Sophus::SE3d Twm = place.key_frame->GetPoseInverse().cast<double>();
  const g2o::Sim3 Swm(Twm.unit_quaternion(), Twm.translation(), 1.0);
  ORB_SLAM3::ORBmatcher matcher(0.9f, true);
  for (const Search& search : {Search{40.0f, 64, 20}, Search{12.0f, 80, 20}}) {
    std::vector<ORB_SLAM3::MapPoint*> matches(key_frame->GetMapPointMatches().size(), nullptr);
    Sophus::Sim3f projection(Eigen::Quaternionf(Scw.rotation().cast<float>()),
                             Scw.translation().cast<float>());
    projection.setScale(static_cast<float>(Scw.scale()));
    // The host's least distance is 50 bits, times this ratio.
    const int found =
        matcher.SearchByProjection(key_frame, projection, points, matches,
                                   static_cast<int>(search.window),
                                   static_cast<float>(search.distance) / 50.0f);
    if (found < search.least) return false;
    g2o::Sim3 Scm = Scw * Swm;
    Eigen::Matrix<double, 7, 7> information;
    const int inliers = ORB_SLAM3::Optimizer::OptimizeSim3(key_frame, place.key_frame, matches, Scm,
                                                           10, fixed_scale, information, true);
    if (inliers < search.least) return false;
    Scw = Scm * Swm.inverse();
  }
  return true;
}

/// What the host keeps of a merge that it has begun to believe in.
struct MergeState {
  ORB_SLAM3::KeyFrame*& matched;
  ORB_SLAM3::KeyFrame*& last;
  g2o::Sim3& Slw;
  int& coincidences;
};

/// Where the host has no merge under way: tries the object poses of the key frame in other maps.
/// One that stands the host's `detect` (its refinement from a known pose) counts as its first
/// coincidence; the next key frames decide, by the host's own rules.
/// @param detect  bool(KeyFrame* matched, g2o::Sim3& Scw)
template <typename Hooks, typename Detect>
void MergeFromPlaces(Hooks& hooks, ORB_SLAM3::KeyFrame* key_frame, bool fixed_scale,
                     MergeState state, Detect detect) {
  if (state.coincidences > 0) return;
  const auto places = hooks.MergePlaces();
  for (std::size_t i = 0; i < places.size(); ++i) {
    ORB_SLAM3::KeyFrame* const matched = places[i].key_frame;
    if (matched->isBad()) continue;
    g2o::Sim3 Scw = SimilarityOf(places[i], fixed_scale);
    if (!RefineSim3(places[i], key_frame, fixed_scale, Scw) || !detect(matched, Scw)) continue;
    matched->SetNotErase();
    state.matched = matched;
    state.last = key_frame;
    state.Slw = Scw;
    state.coincidences = 1;
    hooks.MergePlacesTried(static_cast<int>(i));
    return;
  }
  if (!places.empty()) hooks.MergePlacesTried(-1);
}

}  // namespace topobag_hooks
