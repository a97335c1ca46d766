// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Geometry>
#include <opencv2/core.hpp>

#include <topobag/adaptors/orb_slam/host_pose.hpp>
#include <topobag/sensing/sparse_depth.hpp>

namespace semantic {

/// The features of a frame whose depth the host knows, from its depth camera or its own stereo
/// matching: undistorted pixels and metres. None of a monocular frame; its key
/// frames have `map_point_depths`.
/// @tparam Frame  ORB-SLAM's Frame or KeyFrame: mvKeysUn (elements with pt.x and pt.y), mvDepth
///                (m, not positive: unknown), one for each feature
template <typename Frame>
std::vector<topobag::DepthPoint> feature_depths(const Frame& frame) {
  std::vector<topobag::DepthPoint> points;
  for (std::size_t i = 0; i < frame.mvDepth.size(); ++i) {
    if (!(frame.mvDepth[i] > 0.0F)) continue;
    const auto& pixel = frame.mvKeysUn[i].pt;
    points.push_back({{pixel.x, pixel.y}, frame.mvDepth[i]});
  }
  return points;
}

/// Where a map point is, as ORB-SLAM2 says it, 3 × 1 floats, and as ORB-SLAM3 does.
inline Eigen::Vector3d world_point(const cv::Mat& point) {
  return {point.at<float>(0), point.at<float>(1), point.at<float>(2)};
}
/// The same.
inline Eigen::Vector3d world_point(const Eigen::Vector3f& point) { return point.cast<double>(); }

/// The features of a key frame that see a point of the host's map, with that point's depth: the
/// feature's undistorted pixel, and the host's unit. For monocular hosts; to be called while the
/// host moves neither. Throws topobag::InvalidValue for a pose that is no rigid motion.
/// @tparam KeyFrame  ORB-SLAM's: mvKeysUn, GetPoseInverse(), GetMapPointMatches() (a pointer for
///                   each feature or null, with isBad() and GetWorldPos())
template <typename KeyFrame>
std::vector<topobag::DepthPoint> map_point_depths(KeyFrame& key_frame) {
  const Eigen::Isometry3d T_camera_world = topobag::host_pose(key_frame.GetPoseInverse()).inverse();
  const auto seen = key_frame.GetMapPointMatches();
  std::vector<topobag::DepthPoint> points;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    if (seen[i] == nullptr || seen[i]->isBad()) continue;
    const double z = (T_camera_world * world_point(seen[i]->GetWorldPos())).z();
    if (!(z > 0.0)) continue;
    const auto& pixel = key_frame.mvKeysUn[i].pt;
    points.push_back({{pixel.x, pixel.y}, z});
  }
  return points;
}

}  // namespace semantic
