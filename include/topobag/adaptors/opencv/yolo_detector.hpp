// SPDX-License-Identifier: MIT
#pragma once

#include <fstream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include <opencv2/core.hpp>
#include <opencv2/dnn/dnn.hpp>

#include <topobag/adaptors/opencv/letterbox.hpp>
#include <topobag/adaptors/yolo_heads.hpp>
#include <topobag/error.hpp>
#include <topobag/sensing/non_maximum_suppression.hpp>

namespace topobag {
inline namespace v0 {

/// A YOLO network that OpenCV runs. Not for two threads at a time.
class YoloDetector {
 public:
  /// @param model    ONNX file
  /// @param classes  the class behind each score of the network
  /// Throws Error, which names the file.
  YoloDetector(std::string model, std::vector<ClassId> classes, const YoloOptions& options = {})
      : model_(std::move(model)), classes_(std::move(classes)), options_(options) {
    std::ifstream file(model_, std::ios::binary);
    if (!file) throw Error(model_ + ": the file cannot be read");
    const std::string bytes{std::istreambuf_iterator<char>(file), {}};
    try {
      net_ = cv::dnn::readNetFromONNX(bytes.data(), bytes.size());
    } catch (const cv::Exception&) {
      throw Error(model_ + ": the file is not an ONNX network that OpenCV can read");
    }
  }

  /// The objects in a colour image (8-bit BGR), most confident first; boxes lie in the image and
  /// span a pixel at least. Throws InvalidValue for an empty image, Error when the network and the
  /// options do not fit.
  std::vector<Detection> operator()(const cv::Mat& image) {
    const bool yolox = options_.head == YoloHead::yolox;
    const Letterbox letterbox(image, options_.input_size,
                              yolox ? Letterbox::Place::upper_left : Letterbox::Place::center);
    cv::Mat output;
    try {
      // YOLOX takes BGR, 0 to 255, the others RGB, 0 to 1.
      net_.setInput(cv::dnn::blobFromImage(letterbox.input(), yolox ? 1.0 : 1.0 / 255.0, cv::Size(),
                                           cv::Scalar(), !yolox));
      output = net_.forward();
    } catch (const cv::Exception& error) {
      throw Error(model_ + ": OpenCV cannot run the network on an image of side " +
                  std::to_string(options_.input_size) + ": " + error.err);
    }
    std::vector<Detection> detections;
    for (Detection detection : suppress_non_maxima(detections_in(output), options_.max_iou)) {
      detection.box = letterbox.in_image(detection.box);
      const bool a_pixel_left = detection.box.width() >= 1.0 && detection.box.height() >= 1.0;
      if (a_pixel_left) detections.push_back(detection);
    }
    return detections;
  }

 private:
  /// Throws Error, which names the file, when the output is not the head's.
  std::vector<Detection> detections_in(const cv::Mat& output) const {
    try {
      return decoded(output);
    } catch (const InvalidValue& why) {
      throw Error(model_ + ": " + why.what());
    }
  }

  std::vector<Detection> decoded(const cv::Mat& output) const {
    if (output.dims != 3 || output.type() != CV_32F) {
      throw Error(model_ + ": the network does not put out one table of numbers");
    }
    const NetworkOutput table{output.ptr<float>(), static_cast<std::size_t>(output.size[1]),
                              static_cast<std::size_t>(output.size[2])};
    switch (options_.head) {
      case YoloHead::yolov5:
        return decode_yolov5(table, classes_, options_.min_confidence);
      case YoloHead::yolov8:
        return decode_yolov8(table, classes_, options_.min_confidence);
      case YoloHead::yolox:
        break;
    }
    return decode_yolox(table, classes_, options_.input_size, options_.min_confidence);
  }

  std::string model_;
  cv::dnn::Net net_;
  std::vector<ClassId> classes_;
  YoloOptions options_;
};

}  // namespace v0
}  // namespace topobag
