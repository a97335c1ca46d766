// SPDX-License-Identifier: MIT
#pragma once

#include <opencv2/core.hpp>

#include <detectors.hpp>

/// Of a camera with no distortion: boxes stay where they are.
inline semantic::Calibration small_calibration() {
  semantic::Calibration calibration;
  calibration.camera = {500.0, 500.0, 319.5, 239.5, 640, 480};
  calibration.matrix =
      (cv::Mat_<double>(3, 3) << 500.0, 0.0, 319.5, 0.0, 500.0, 239.5, 0.0, 0.0, 1.0);
  calibration.distortion = cv::Mat::zeros(5, 1, CV_64F);
  calibration.baseline = 0.1;
  return calibration;
}
