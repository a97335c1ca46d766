// SPDX-License-Identifier: MIT
// What the hooks of ORB-SLAM2 call of it, on types of our own: under the names that they include.
#pragma once

#include <cstddef>
#include <set>
#include <vector>

#include <opencv2/core.hpp>

#include "../small_matches.hpp"

namespace ORB_SLAM2 {

struct MapPoint {};

struct KeyFrame {
  std::vector<MapPoint*> points;

  bool isBad() const { return false; }
  std::vector<KeyFrame*> GetBestCovisibilityKeyFrames(int) const { return {}; }
};

struct Frame {
  int N = 0;
  std::vector<MapPoint*> mvpMapPoints;
  std::vector<bool> mvbOutlier;
  cv::Mat mTcw;

  void SetPose(const cv::Mat& Tcw) { mTcw = Tcw.clone(); }
};

/// Matches a key frame's points in order, wherever the camera is.
struct ORBmatcher {
  ORBmatcher(float, bool) {}

  void SearchByProjection(Frame& frame, KeyFrame* key_frame, const std::set<MapPoint*>&, float,
                          int) {
    match_in_order(frame, *key_frame);
  }
};

struct Optimizer {
  static int PoseOptimization(Frame* frame) { return count_matches(frame->mvpMapPoints); }
};

/// Finds a pose where there are 55 matches, turns the first away, and moves 1 along x.
struct PnPsolver {
  PnPsolver(const Frame& frame, const std::vector<MapPoint*>& matches)
      : pose(frame.mTcw.clone()), count(count_matches(matches)), features(matches.size()) {}

  void SetRansacParameters(double, int, int, int, float, float) {}
  cv::Mat iterate(int, bool&, std::vector<bool>& inliers, int&) {
    if (count < 55) return {};
    inliers.assign(features, true);
    inliers[0] = false;
    pose.at<float>(0, 3) += 1.0F;
    return pose;
  }

  cv::Mat pose;
  int count;
  std::size_t features;
};

}  // namespace ORB_SLAM2
