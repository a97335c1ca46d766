// SPDX-License-Identifier: MIT
// Tests the places of a semantic map by the host's own means; included by the host's Tracking.cc.
#pragma once

#include <cstddef>
#include <vector>

#include "Frame.h"
#include "KeyFrame.h"
#include "MLPnPsolver.h"
#include "MapPoint.h"
#include "ORBmatcher.h"
#include "Optimizer.h"
#include "PlaceSearch.h"

namespace topobag_hooks {

/// The place's pose as the host has it.
template <typename KeyFrame>
Sophus::SE3f PoseOf(const Place<KeyFrame>& place) {
  const Eigen::Matrix4f T =
      Eigen::Map<const Eigen::Matrix<float, 4, 4, Eigen::RowMajor>>(place.Tcw.data());
  const Eigen::Matrix3f R = T.topLeftCorner<3, 3>();
  const Eigen::Vector3f t = T.topRightCorner<3, 1>();
  return Sophus::SE3f(Eigen::Quaternionf(R).normalized(), t);
}

struct OrbSlam3 {
  using KeyFrame = ORB_SLAM3::KeyFrame;
  using Frame = ORB_SLAM3::Frame;
  using MapPoint = ORB_SLAM3::MapPoint;
  using ORBmatcher = ORB_SLAM3::ORBmatcher;
  using Optimizer = ORB_SLAM3::Optimizer;

  static void SetPose(Frame& frame, const Place<KeyFrame>& place) { frame.SetPose(PoseOf(place)); }

  static void ApplyRansac(Frame& frame) {
    // The host declares its destructor and has none: it is never destroyed, as the host's own.
    auto& solver = *new ORB_SLAM3::MLPnPsolver(frame, frame.mvpMapPoints);
    solver.SetRansacParameters(0.99, 10, 300, 6, 0.5f, 5.991f);
    std::vector<bool> inliers;
    bool finished = false;
    int count = 0;
    Eigen::Matrix4f Tcw;
    if (!solver.iterate(300, finished, inliers, count, Tcw)) return;
    const Eigen::Matrix3f R = Tcw.topLeftCorner<3, 3>();
    const Eigen::Vector3f t = Tcw.topRightCorner<3, 1>();
    frame.SetPose(Sophus::SE3f(Eigen::Quaternionf(R).normalized(), t));
    for (std::size_t i = 0; i < inliers.size(); ++i) {
      if (!inliers[i]) frame.mvpMapPoints[i] = nullptr;
    }
  }
};

/// As `PlaceSearch::Relocalize`.
template <typename Hooks>
bool RelocalizeFromPlaces(Hooks& hooks, ORB_SLAM3::Frame& frame) {
  return PlaceSearch<OrbSlam3>::Relocalize(hooks, frame);
}

}  // namespace topobag_hooks
