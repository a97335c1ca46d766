// SPDX-License-Identifier: MIT
#include "object_detector.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <opencv2/imgproc.hpp>

#include "csv_reader.hpp"

namespace program {

ObjectDetector::ObjectDetector(const std::string& model, std::vector<topobag::ClassId> classes,
                               const YoloxOptions& options)
    : model_(model), classes_(std::move(classes)), options_(options) {
  const std::string bytes = read_file(model);
  try {
    net_ = cv::dnn::readNetFromONNX(bytes.data(), bytes.size());
  } catch (const cv::Exception&) {
    throw InputError(model, "the file is not an ONNX network that OpenCV can read");
  }
}

std::vector<topobag::Detection> ObjectDetector::operator()(const cv::Mat& image) {
  // The image goes to the upper left of the input, shrunk as one; the rest is grey.
  const int side = options_.input_size;
  const double shrink = static_cast<double>(side) / std::max(image.cols, image.rows);
  const cv::Size size(std::clamp(static_cast<int>(std::lround(image.cols * shrink)), 1, side),
                      std::clamp(static_cast<int>(std::lround(image.rows * shrink)), 1, side));
  cv::Mat input(side, side, CV_8UC3, cv::Scalar::all(114));
  cv::Mat target = input(cv::Rect(cv::Point(0, 0), size));
  cv::resize(image, target, size);

  cv::Mat output;
  try {
    net_.setInput(cv::dnn::blobFromImage(input));
    output = net_.forward();
  } catch (const cv::Exception& error) {
    throw InputError(model_, "OpenCV cannot run the network on an image of side " +
                                 std::to_string(side) + ": " + error.err);
  }
  if (output.dims != 3 || output.type() != CV_32F) {
    throw InputError(model_, "the network does not put out one table of numbers");
  }
  const YoloxOutput table{output.ptr<float>(), static_cast<std::size_t>(output.size[1]),
                          static_cast<std::size_t>(output.size[2])};
  std::vector<topobag::Detection> found =
      suppress_non_maxima(decode_yolox(table, classes_, options_), options_.max_iou);

  // The network measures from the corner of the first pixel, topobag from its centre.
  const double x_scale = static_cast<double>(image.cols) / size.width;
  const double y_scale = static_cast<double>(image.rows) / size.height;
  std::vector<topobag::Detection> detections;
  for (topobag::Detection& detection : found) {
    const topobag::BoundingBox& box = detection.box;
    detection.box = topobag::BoundingBox{box.x1 * x_scale - 0.5, box.y1 * y_scale - 0.5,
                                         box.x2 * x_scale - 0.5, box.y2 * y_scale - 0.5}
                        .clipped(image.cols, image.rows);
    const bool a_pixel_left = detection.box.width() >= 1.0 && detection.box.height() >= 1.0;
    if (a_pixel_left) detections.push_back(detection);
  }
  return detections;
}

}  // namespace program
