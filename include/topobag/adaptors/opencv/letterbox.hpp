// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include <topobag/error.hpp>
#include <topobag/types/bounding_box.hpp>

namespace topobag {
inline namespace v0 {

/// An image scaled as one into a network's square input, the rest grey, and the way back.
class Letterbox {
 public:
  /// Where on the square the image lies.
  enum class Place { upper_left, center };

  /// Throws InvalidValue for an empty image or a side below 1.
  Letterbox(const cv::Mat& image, int side, Place place) : image_size_(image.size()) {
    if (image.empty() || side < 1) throw InvalidValue("there is no image to scale");
    const double scale = static_cast<double>(side) / std::max(image.cols, image.rows);
    size_ = {std::clamp(static_cast<int>(std::lround(image.cols * scale)), 1, side),
             std::clamp(static_cast<int>(std::lround(image.rows * scale)), 1, side)};
    if (place == Place::center) {
      offset_ = {(side - size_.width) / 2, (side - size_.height) / 2};
    }
    input_ = cv::Mat(side, side, image.type(), cv::Scalar::all(114));
    cv::Mat target = input_(cv::Rect(offset_, size_));
    cv::resize(image, target, size_);
  }

  /// The square image for the network.
  const cv::Mat& input() const noexcept { return input_; }

  /// A box of the input (px from its upper-left corner) in the image, clipped to it and measured
  /// from the centre of its first pixel; not valid when nothing is left.
  BoundingBox in_image(const BoundingBox& box) const noexcept {
    const double x_scale = static_cast<double>(image_size_.width) / size_.width;
    const double y_scale = static_cast<double>(image_size_.height) / size_.height;
    return BoundingBox{(box.x1 - offset_.x) * x_scale - 0.5, (box.y1 - offset_.y) * y_scale - 0.5,
                       (box.x2 - offset_.x) * x_scale - 0.5, (box.y2 - offset_.y) * y_scale - 0.5}
        .clipped(image_size_.width, image_size_.height);
  }

 private:
  cv::Size image_size_;
  cv::Size size_;
  cv::Point offset_{0, 0};
  cv::Mat input_;
};

}  // namespace v0
}  // namespace topobag
