// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <vector>

#include <opencv2/calib3d.hpp>
#include <opencv2/core.hpp>

#include <topobag/types/bounding_box.hpp>
#include <topobag/types/ranged_detection.hpp>

namespace topobag {
inline namespace v0 {

namespace detail {

/// The box, moved, with the sides at the image's border that were there before: what the border
/// cuts goes on beyond it.
inline BoundingBox kept_cut(BoundingBox moved, const BoundingBox& before, const cv::Size& image) {
  const double margin = BoundingBox::cut_margin;
  const double right = image.width - 1.0, lower = image.height - 1.0;
  if (before.x1 < margin) moved.x1 = std::min(moved.x1, 0.0);
  if (before.y1 < margin) moved.y1 = std::min(moved.y1, 0.0);
  if (before.x2 > right - margin) moved.x2 = std::max(moved.x2, right);
  if (before.y2 > lower - margin) moved.y2 = std::max(moved.y2, lower);
  return moved;
}

}  // namespace detail

/// Moves each valid box to where a camera without distortion would see its centre; sizes stay, but
/// of boxes that the image's border cuts: those still reach it, for lifting tells them by that.
/// For detections in a distorted image that have got their depths, which lie in that image too.
/// @param camera_matrix  3 × 3, px
/// @param distortion     OpenCV's k1, k2, p1, p2, …; empty = none
/// @param image          its size; not positive = not known: cut boxes pass for whole ones
/// O(n).
inline std::vector<RangedDetection> undistorted(std::vector<RangedDetection> detections,
                                                const cv::Mat& camera_matrix,
                                                const cv::Mat& distortion,
                                                const cv::Size& image = {}) {
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
    const BoundingBox before = detection.box;
    detection.box = box_around({center.x, center.y}, before.width(), before.height());
    if (!image.empty()) detection.box = detail::kept_cut(detection.box, before, image);
  }
  return detections;
}

}  // namespace v0
}  // namespace topobag
