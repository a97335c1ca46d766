// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <opencv2/calib3d.hpp>
#include <opencv2/core.hpp>

#include <topobag/types/ranged_detection.hpp>

namespace topobag {
inline namespace v0 {

/// Moves each valid box to where a camera without distortion would see its centre; sizes stay.
/// For detections in a distorted image that have got their depths, which lie in that image too.
/// @param camera_matrix  3 × 3, px
/// @param distortion     OpenCV's k1, k2, p1, p2, …; empty = none
/// O(n).
inline std::vector<RangedDetection> undistorted(std::vector<RangedDetection> detections,
                                                const cv::Mat& camera_matrix,
                                                const cv::Mat& distortion) {
  std::vector<cv::Point2d> centers, straight;
  for (const RangedDetection& detection : detections) {
    if (!detection.box.is_valid()) continue;
    centers.emplace_back(detection.box.center().x(), detection.box.center().y());
  }
  if (centers.empty()) return detections;
  cv::undistortPoints(centers, straight, camera_matrix, distortion, cv::noArray(), camera_matrix);
  auto next = straight.begin();
  for (RangedDetection& detection : detections) {
    if (!detection.box.is_valid()) continue;
    const cv::Point2d center = *next++;
    detection.box = box_around({center.x, center.y}, detection.box.width(), detection.box.height());
  }
  return detections;
}

}  // namespace v0
}  // namespace topobag
