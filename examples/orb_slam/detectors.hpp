// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <opencv2/calib3d.hpp>
#include <opencv2/core/persistence.hpp>

#include <topobag/adaptors/opencv.hpp>
#include <topobag/error.hpp>
#include <topobag/sensing/disparity_depth.hpp>
#include <topobag/sensing/range_detections.hpp>
#include <topobag/sensing/sparse_depth.hpp>

#include "semantic_slam.hpp"
#include "table_rows.hpp"

namespace semantic {

/// What the host's settings say of the camera.
struct Calibration {
  topobag::PinholeCamera<> camera;
  cv::Mat matrix, distortion;
  double depth_scale = 1.0;
  double baseline = 0.0;  ///< m; of a stereo camera
};

/// A number of the settings under its name of ORB-SLAM2 or that of ORB-SLAM3; 0 = it has none.
inline double setting(const cv::FileStorage& file, const std::string& name,
                      const std::string& renamed) {
  const cv::FileNode node = file[name].empty() ? file[renamed] : file[name];
  return node.empty() ? 0.0 : static_cast<double>(node);
}

/// Throws topobag::Error when the file cannot be read.
inline Calibration read_calibration(const std::string& settings) {
  const cv::FileStorage file(settings, cv::FileStorage::READ);
  if (!file.isOpened()) throw topobag::Error(settings + ": the file cannot be read");
  Calibration calibration;
  auto& camera = calibration.camera;
  camera.fx = setting(file, "Camera.fx", "Camera1.fx");
  camera.fy = setting(file, "Camera.fy", "Camera1.fy");
  camera.cx = setting(file, "Camera.cx", "Camera1.cx");
  camera.cy = setting(file, "Camera.cy", "Camera1.cy");
  camera.width = static_cast<int>(file["Camera.width"]);
  camera.height = static_cast<int>(file["Camera.height"]);
  camera.validate();
  calibration.matrix = (cv::Mat_<double>(3, 3) << camera.fx, 0.0, camera.cx, 0.0, camera.fy,
                        camera.cy, 0.0, 0.0, 1.0);
  calibration.distortion = cv::Mat::zeros(5, 1, CV_64F);
  const char* const names[] = {"k1", "k2", "p1", "p2", "k3"};
  for (int i = 0; i < 5; ++i) {
    const std::string name = names[i];
    calibration.distortion.at<double>(i) = setting(file, "Camera." + name, "Camera1." + name);
  }
  calibration.depth_scale = setting(file, "DepthMapFactor", "RGBD.DepthMapFactor");
  calibration.baseline = setting(file, "Stereo.b", "Stereo.b");
  if (calibration.baseline == 0.0) {
    calibration.baseline = setting(file, "Camera.bf", "Camera.bf") / camera.fx;
  }
  return calibration;
}

/// What the rows of node tables say; neither undistorted. Nothing of an image that they lack.
inline Detect table_detector(TableRows rows) {
  return [rows = std::move(rows)](const Images& images) {
    const TableRows::Boxes* found = rows.find(images.stamp);
    return found ? *found : TableRows::Boxes{};
  };
}

/// Where a camera without distortion would see the boxes.
inline std::vector<topobag::RangedDetection> straight(std::vector<topobag::RangedDetection> boxes,
                                                      const Calibration& calibration) {
  return topobag::undistorted(std::move(boxes), calibration.matrix, calibration.distortion,
                              {calibration.camera.width, calibration.camera.height});
}

/// Boxes that know their depths already; none of an image whose depth image shows nothing.
inline Detect undistorted(const Detect& boxes, const Calibration& calibration) {
  return [boxes, calibration](const Images& images) {
    auto found = boxes(images);
    if (cv::countNonZero(images.depth) == 0) {
      for (topobag::RangedDetection& box : found) box.z = 0.0;
    }
    return straight(std::move(found), calibration);
  };
}

/// The boxes of a YOLOX network, without depths.
inline Detect network_detector(const std::string& model, const Calibration& calibration) {
  auto network =
      std::make_shared<topobag::YoloDetector>(model, topobag::ClassCatalog::coco80().ids());
  return [network, calibration](const Images& images) {
    std::vector<topobag::RangedDetection> boxes;
    for (const topobag::Detection& found : (*network)(images.rgb)) {
      boxes.push_back({found.box, found.label, found.confidence});
    }
    return boxes;
  };
}

/// Boxes with the depths of the depth image, which is as distorted as they are; undistorted then.
inline Detect with_depth_image(const Detect& boxes, const Calibration& calibration) {
  return [boxes, calibration](const Images& images) {
    return straight(topobag::range_detections(
                        boxes(images), topobag::DepthImage(images.depth, calibration.depth_scale),
                        calibration.camera),
                    calibration);
  };
}

/// Boxes with the depths of the host's own features in them, which are undistorted: without a depth
/// image. What the boxes knew of depth is forgotten.
inline Detect with_feature_depths(const Detect& boxes, const Calibration& calibration) {
  return [boxes, calibration](const Images& images) {
    return topobag::range_detections(straight(boxes(images), calibration),
                                     topobag::SparseDepth(images.points), calibration.camera,
                                     topobag::SparseBoxDepth{});
  };
}

/// The disparities of a rectified pair, 16 a pixel, of up to 128 px; negative where there is none.
/// The matcher has none for the columns that it could not compare with all 128: a border beside
/// both images gives them theirs, but for what would lie in the right one's border.
inline cv::Mat disparities(const cv::Mat& left, const cv::Mat& right, cv::StereoSGBM& matcher) {
  const int border = matcher.getNumDisparities();
  cv::Mat wide_left, wide_right, wide;
  cv::copyMakeBorder(left, wide_left, 0, 0, border, 0, cv::BORDER_CONSTANT);
  cv::copyMakeBorder(right, wide_right, 0, 0, border, 0, cv::BORDER_CONSTANT);
  matcher.compute(wide_left, wide_right, wide);
  cv::Mat disparity = wide.colRange(border, wide.cols).clone();
  for (int column = 0; column < std::min(border, disparity.cols); ++column) {
    cv::Mat here = disparity.col(column);
    here.setTo(-cv::StereoMatcher::DISP_SCALE, here > cv::StereoMatcher::DISP_SCALE * column);
  }
  return disparity;
}

/// Boxes with the depths of the disparities of a rectified pair, of up to 128 px. What the boxes
/// knew of depth is forgotten. Throws topobag::Error for settings that say nothing of a baseline.
inline Detect with_disparities(const Detect& boxes, const Calibration& calibration) {
  if (!(calibration.baseline > 0.0)) {
    throw topobag::Error(
        "--depth stereo needs the distance of the two cameras, and the settings have no positive "
        "one: give them Stereo.b, in m, or Camera.bf, which is that times Camera.fx");
  }
  const cv::Ptr<cv::StereoSGBM> matcher = cv::StereoSGBM::create(0, 128, 5, 200, 800);
  return [boxes, calibration, matcher](const Images& images) {
    const cv::Mat disparity = disparities(images.rgb, images.depth, *matcher);
    const topobag::DisparityDepth depth(
        topobag::DepthImage(disparity, cv::StereoMatcher::DISP_SCALE), calibration.camera.fx,
        calibration.baseline);
    return topobag::range_detections(boxes(images), depth, calibration.camera);
  };
}

}  // namespace semantic
