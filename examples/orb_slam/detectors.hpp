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

/// Throws topobag::Error when the file cannot be read.
inline Calibration read_calibration(const std::string& settings) {
  const cv::FileStorage file(settings, cv::FileStorage::READ);
  if (!file.isOpened()) throw topobag::Error(settings + ": the file cannot be read");
  Calibration calibration;
  auto& camera = calibration.camera;
  camera.fx = static_cast<double>(file["Camera.fx"]);
  camera.fy = static_cast<double>(file["Camera.fy"]);
  camera.cx = static_cast<double>(file["Camera.cx"]);
  camera.cy = static_cast<double>(file["Camera.cy"]);
  camera.width = static_cast<int>(file["Camera.width"]);
  camera.height = static_cast<int>(file["Camera.height"]);
  camera.validate();
  calibration.matrix = (cv::Mat_<double>(3, 3) << camera.fx, 0.0, camera.cx, 0.0, camera.fy,
                        camera.cy, 0.0, 0.0, 1.0);
  calibration.distortion = cv::Mat::zeros(5, 1, CV_64F);
  const char* const names[] = {"Camera.k1", "Camera.k2", "Camera.p1", "Camera.p2", "Camera.k3"};
  for (int i = 0; i < 5; ++i) {
    if (!file[names[i]].empty()) {
      calibration.distortion.at<double>(i) = static_cast<double>(file[names[i]]);
    }
  }
  calibration.depth_scale = static_cast<double>(file["DepthMapFactor"]);
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
