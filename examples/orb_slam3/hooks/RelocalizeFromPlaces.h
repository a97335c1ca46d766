// SPDX-License-Identifier: MIT
// Tests the places of a semantic map by the host's own means; included by the host's Tracking.cc.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include <opencv2/calib3d.hpp>

#include "Frame.h"
#include "KeyFrame.h"
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
    Sophus::SE3f Tcw;
    if (FindPose(frame, frame.mvpMapPoints, Tcw)) frame.SetPose(Tcw);
  }

  /// The pose of a frame or a key frame by its matches, a map point or null for each feature, of
  /// which its inliers are kept; where it finds none, they stay. By OpenCV's RANSAC, which takes
  /// four points a sample. The host's own takes six: where one match in three is right, its 35
  /// samples hold hardly ever one without a wrong match.
  template <typename Seen>
  static bool FindPose(const Seen& seen, std::vector<MapPoint*>& matches, Sophus::SE3f& Tcw) {
    std::vector<std::size_t> features;
    std::vector<cv::Point3f> points;
    std::vector<cv::Point2f> rays;  // where they meet the plane one unit before the camera
    const std::size_t count = std::min(matches.size(), seen.mvKeysUn.size());
    for (std::size_t i = 0; i < count; ++i) {
      if (!matches[i]) continue;
      const cv::Point3f ray = seen.mpCamera->unproject(seen.mvKeysUn[i].pt);
      if (!(ray.z > 0.0f)) continue;
      const Eigen::Vector3f position = matches[i]->GetWorldPos();
      features.push_back(i);
      points.emplace_back(position.x(), position.y(), position.z());
      rays.emplace_back(ray.x / ray.z, ray.y / ray.z);
    }
    const std::size_t least = std::max<std::size_t>(10, points.size() / 5);
    if (points.size() < least) return false;
    const float tolerance = 4.0f / seen.mpCamera->getParameter(0);  // px over the focal length
    cv::Mat rotation, translation;
    std::vector<int> inliers;
    if (!cv::solvePnPRansac(points, rays, cv::Mat::eye(3, 3, CV_64F), cv::noArray(), rotation,
                            translation, false, 500, tolerance, 0.99, inliers, cv::SOLVEPNP_AP3P) ||
        inliers.size() < least) {
      return false;
    }
    Eigen::Vector3f axis, t;
    for (int i = 0; i < 3; ++i) {
      axis[i] = static_cast<float>(rotation.at<double>(i));
      t[i] = static_cast<float>(translation.at<double>(i));
    }
    const float angle = axis.norm();
    const Eigen::Vector3f unit = angle > 0.0f ? Eigen::Vector3f(axis / angle) : axis;
    Tcw = Sophus::SE3f(Eigen::Quaternionf(Eigen::AngleAxisf(angle, unit)), t);
    std::vector<MapPoint*> kept(matches.size(), nullptr);
    for (const int inlier : inliers) {
      const std::size_t feature = features[static_cast<std::size_t>(inlier)];
      kept[feature] = matches[feature];
    }
    matches = kept;
    return true;
  }
};

/// As `PlaceSearch::Relocalize`.
template <typename Hooks>
bool RelocalizeFromPlaces(Hooks& hooks, ORB_SLAM3::Frame& frame) {
  return PlaceSearch<OrbSlam3>::Relocalize(hooks, frame);
}

}  // namespace topobag_hooks
