// SPDX-License-Identifier: MIT
#include "detect_nodes.hpp"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <utility>

#include <opencv2/core/utils/logger.hpp>
#include <opencv2/imgcodecs.hpp>

#include <topobag/adaptors/opencv.hpp>
#include <topobag/sensing/color_descriptor.hpp>
#include <topobag/sensing/depth_grid.hpp>
#include <topobag/sensing/describe_detections.hpp>
#include <topobag/sensing/range_detections.hpp>

#include "input_error.hpp"
#include "progress.hpp"

namespace program {
namespace {

cv::Mat read_image(const std::string& path, int flags) {
  if (!std::filesystem::exists(path)) throw InputError(path, "there is no such image");
  cv::Mat image = cv::imread(path, flags);
  if (image.empty()) throw InputError(path, "the file is not an image that OpenCV can read");
  return image;
}

cv::Mat read_depth(const std::string& path, const cv::Size& size) {
  cv::Mat depth = read_image(path, cv::IMREAD_UNCHANGED);
  if (depth.type() != CV_16UC1) {
    throw InputError(path, "a depth image has one channel of 16 bits");
  }
  if (depth.size() != size) {
    throw InputError(path, "the depth image has another size than its colour image; register it");
  }
  return depth;
}

void require_size(const cv::Mat& image, const std::string& path,
                  const topobag::PinholeCamera<>& camera) {
  if (image.cols == camera.width && image.rows == camera.height) return;
  throw InputError(path, "the image is " + std::to_string(image.cols) + " x " +
                             std::to_string(image.rows) + " px, the camera's " +
                             std::to_string(camera.width) + " x " + std::to_string(camera.height));
}

/// A box of which the image shows less than a pixel is nothing that a table could keep. Returns how
/// many there were.
std::size_t drop_outside(std::vector<topobag::RangedDetection>& detections) {
  const auto outside = [](const topobag::RangedDetection& detection) {
    return !(detection.box.width() >= 1.0 && detection.box.height() >= 1.0);
  };
  const auto kept = std::remove_if(detections.begin(), detections.end(), outside);
  const auto count = static_cast<std::size_t>(detections.end() - kept);
  detections.erase(kept, detections.end());
  return count;
}

}  // namespace

ImageSize size_of_image(const std::string& path) {
  const cv::Mat image = read_image(path, cv::IMREAD_COLOR | cv::IMREAD_IGNORE_ORIENTATION);
  return {image.cols, image.rows};
}

DetectedNodes detect_nodes(const std::vector<RgbdFrame>& frames, const DetectionSource& source,
                           double depth_scale, const topobag::PinholeCamera<>& camera,
                           NodesCheckpoint& checkpoint) {
  cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);  // errors are ours to tell
  std::optional<topobag::YoloDetector> network;
  if (!source.boxes) network.emplace(source.model, source.classes, source.yolo);
  DetectedNodes detected = checkpoint.earlier(frames);
  Progress progress(frames.size(), "images");
  if (source.colors) detected.table.appearance = topobag::ColorDescriptor::name;
  if (!source.layer.empty()) detected.table.appearance = network->appearance_name(source.layer);
  progress.step(detected.table.frames.size());
  for (std::size_t i = detected.table.frames.size(); i < frames.size(); ++i) {
    const RgbdFrame& frame = frames[i];
    const cv::Mat rgb = read_image(frame.rgb, cv::IMREAD_COLOR | cv::IMREAD_IGNORE_ORIENTATION);
    require_size(rgb, frame.rgb, camera);
    const cv::Mat depth = read_depth(frame.depth, rgb.size());
    const topobag::DepthImage depths(depth, depth_scale);
    FrameRow row = row_of(frame, i);
    row.detections =
        source.layer.empty()
            ? topobag::range_detections(network ? (*network)(rgb) : source.boxes->of_image[i],
                                        depths, camera)
            : topobag::range_detections(network->described(rgb, source.layer), depths, camera);
    row.depth = topobag::DepthGrid(depths, camera.width, camera.height).levels();
    detected.outside += drop_outside(row.detections);
    if (source.colors) {
      topobag::describe_detections(row.detections, topobag::color_image(rgb), depths);
    }
    detected.table.frames.push_back(std::move(row));
    checkpoint.keep(detected);
    progress.step();
  }
  return detected;
}

}  // namespace program
