// SPDX-License-Identifier: MIT
// Tests the places of a semantic map by the host's own means; included by the host's Tracking.cc.
#pragma once

#include <set>
#include <vector>

#include "Frame.h"
#include "KeyFrame.h"
#include "MapPoint.h"
#include "ORBmatcher.h"
#include "Optimizer.h"
#include "PnPsolver.h"
#include "SemanticHooks.h"

namespace topobag_hooks {

/// Matches the frame, at its present pose, with the map points of the key frames: within `window`
/// px at the finest level and `distance` bits.
inline int MatchByProjection(ORB_SLAM2::Frame& frame,
                             const std::vector<ORB_SLAM2::KeyFrame*>& key_frames, float window,
                             int distance) {
  ORB_SLAM2::ORBmatcher matcher(0.9f, true);
  std::set<ORB_SLAM2::MapPoint*> found;
  for (ORB_SLAM2::MapPoint* point : frame.mvpMapPoints) {
    if (point) found.insert(point);
  }
  for (ORB_SLAM2::KeyFrame* key_frame : key_frames) {
    matcher.SearchByProjection(frame, key_frame, found, window, distance);
    for (ORB_SLAM2::MapPoint* point : frame.mvpMapPoints) {
      if (point) found.insert(point);
    }
  }
  return static_cast<int>(found.size());
}

/// Optimises the frame's pose and lets go of outliers; the number of inliers.
inline int OptimizePose(ORB_SLAM2::Frame& frame) {
  const int good = ORB_SLAM2::Optimizer::PoseOptimization(&frame);
  for (int i = 0; i < frame.N; ++i) {
    if (frame.mvbOutlier[i]) frame.mvpMapPoints[i] = nullptr;
  }
  return good;
}

/// Sets the pose that RANSAC finds among the frame's matches and keeps its inliers; where it finds
/// none, pose and matches stay.
inline void ApplyRansac(ORB_SLAM2::Frame& frame) {
  ORB_SLAM2::PnPsolver solver(frame, frame.mvpMapPoints);
  solver.SetRansacParameters(0.99, 10, 300, 4, 0.2f, 5.991f);
  std::vector<bool> inliers;
  bool finished = false;
  int count = 0;
  const cv::Mat Tcw = solver.iterate(300, finished, inliers, count);
  if (Tcw.empty()) return;
  frame.SetPose(Tcw);
  for (std::size_t i = 0; i < inliers.size(); ++i) {
    if (!inliers[i]) frame.mvpMapPoints[i] = nullptr;
  }
}

/// A search for the matches of a projected map point.
struct Search {
  float window;  // px at the finest level
  int distance;  // bits
  int least;     // inliers to go on with
};

/// Whether the frame, from the pose it has, gets a pose with 50 inliers, as the host asks
/// elsewhere, in searches that narrow while the pose gets better.
inline bool Converges(ORB_SLAM2::Frame& frame, const std::vector<ORB_SLAM2::KeyFrame*>& key_frames,
                      const Search& first) {
  const Search searches[] = {first, {12.0f, 80, 20}, {4.0f, 100, 50}};
  for (const Search& search : searches) {
    frame.mvpMapPoints.assign(static_cast<std::size_t>(frame.N), nullptr);
    frame.mvbOutlier.assign(static_cast<std::size_t>(frame.N), false);
    if (MatchByProjection(frame, key_frames, search.window, search.distance) < search.least) {
      return false;
    }
    if (&search == searches) ApplyRansac(frame);
    if (OptimizePose(frame) < search.least) return false;
  }
  return true;
}

/// Whether the place is the frame's: its map points are projected with the object pose. A pose of
/// few objects may be 10 degrees off, 90 px: where a narrow first window fails, a wide one, that
/// asks for more alike descriptors, gets its turn.
inline bool StandsAt(const Place<ORB_SLAM2::KeyFrame>& place, ORB_SLAM2::Frame& frame) {
  std::vector<ORB_SLAM2::KeyFrame*> key_frames = place.key_frame->GetBestCovisibilityKeyFrames(10);
  key_frames.insert(key_frames.begin(), place.key_frame);
  const cv::Mat Tcw(4, 4, CV_32F, const_cast<float*>(place.Tcw.data()));
  for (const Search& first : {Search{40.0f, 64, 10}, Search{100.0f, 50, 10}}) {
    frame.SetPose(Tcw);
    if (Converges(frame, key_frames, first)) return true;
  }
  return false;
}

/// Tries the places one after the other. On success the frame has its pose and its map points; else
/// it is left without either. Needs a frame for which `RelocalizationCandidates` was called.
template <typename Hooks>
bool RelocalizeFromPlaces(Hooks& hooks, ORB_SLAM2::Frame& frame) {
  const auto places = hooks.Places();
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (places[i].key_frame->isBad() || !StandsAt(places[i], frame)) continue;
    hooks.PlacesTried(static_cast<int>(i));
    return true;
  }
  if (!places.empty()) {
    frame.mTcw = cv::Mat();
    frame.mvpMapPoints.assign(static_cast<std::size_t>(frame.N), nullptr);
    hooks.PlacesTried(-1);
  }
  return false;
}

}  // namespace topobag_hooks
