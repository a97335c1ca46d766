// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <opencv2/core/mat.hpp>
#include <opencv2/dnn/dnn.hpp>

#include <topobag/types/detection.hpp>

#include "yolox.hpp"

namespace program {

/// A YOLOX network that OpenCV runs.
class ObjectDetector {
 public:
  /// @param model    ONNX file
  /// @param classes  the class behind each score of the network
  /// Throws InputError.
  ObjectDetector(const std::string& model, std::vector<topobag::ClassId> classes,
                 const YoloxOptions& options);

  /// The objects in a colour image (8-bit BGR), most confident first; boxes lie in the image.
  std::vector<topobag::Detection> operator()(const cv::Mat& image);

 private:
  std::string model_;
  cv::dnn::Net net_;
  std::vector<topobag::ClassId> classes_;
  YoloxOptions options_;
};

}  // namespace program
