// SPDX-License-Identifier: MIT
// Tests the places of a semantic map by the host's own means; included by the host's Tracking.cc.
#pragma once

#include <vector>

#include "Frame.h"
#include "KeyFrame.h"
#include "MapPoint.h"
#include "ORBmatcher.h"
#include "Optimizer.h"
#include "PlaceSearch.h"
#include "PnPsolver.h"

namespace topobag_hooks {

struct OrbSlam2 {
  using KeyFrame = ORB_SLAM2::KeyFrame;
  using Frame = ORB_SLAM2::Frame;
  using MapPoint = ORB_SLAM2::MapPoint;
  using ORBmatcher = ORB_SLAM2::ORBmatcher;
  using Optimizer = ORB_SLAM2::Optimizer;

  static void SetPose(Frame& frame, const Place<KeyFrame>& place) {
    frame.SetPose(cv::Mat(4, 4, CV_32F, const_cast<float*>(place.Tcw.data())));
  }

  static void ApplyRansac(Frame& frame) {
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
};

/// As `PlaceSearch::Relocalize`; without success the frame has no pose either.
template <typename Hooks>
bool RelocalizeFromPlaces(Hooks& hooks, ORB_SLAM2::Frame& frame) {
  if (PlaceSearch<OrbSlam2>::Relocalize(hooks, frame)) return true;
  frame.mTcw = cv::Mat();
  return false;
}

}  // namespace topobag_hooks
