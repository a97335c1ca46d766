// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <opencv2/core/persistence.hpp>

#include <topobag/adaptors/opencv.hpp>
#include <topobag/error.hpp>
#include <topobag/sensing/range_detections.hpp>

#include <node_table.hpp>

#include "semantic_slam.hpp"

namespace semantic {

/// What the host's settings say of the camera.
struct Calibration {
  topobag::PinholeCamera<> camera;
  cv::Mat matrix, distortion;
  double depth_scale = 1.0;
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
  return calibration;
}

/// What the rows of node tables say, by the stamp of the image.
inline Detect table_detector(const std::vector<std::string>& tables,
                             const Calibration& calibration) {
  std::map<double, std::vector<topobag::RangedDetection>> rows;
  for (const std::string& table : tables) {
    for (program::FrameRow& frame : program::read_node_table(table).frames) {
      rows[frame.timestamp] = std::move(frame.detections);
    }
  }
  return [rows = std::move(rows), calibration](const Images& images) {
    const auto found = rows.lower_bound(images.stamp - 1e-5);
    if (found == rows.end() || found->first > images.stamp + 1e-5) {
      return std::vector<topobag::RangedDetection>{};
    }
    return topobag::undistorted(found->second, calibration.matrix, calibration.distortion);
  };
}

/// A YOLOX network with the depth image.
inline Detect network_detector(const std::string& model, const Calibration& calibration) {
  auto network =
      std::make_shared<topobag::YoloDetector>(model, topobag::ClassCatalog::coco80().ids());
  return [network, calibration](const Images& images) {
    return topobag::undistorted(
        topobag::range_detections((*network)(images.rgb),
                                  topobag::DepthImage(images.depth, calibration.depth_scale),
                                  calibration.camera),
        calibration.matrix, calibration.distortion);
  };
}

}  // namespace semantic
