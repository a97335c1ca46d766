// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include <opencv2/core.hpp>

#include <topobag/error.hpp>
#include <topobag/sensing/depth_view.hpp>

namespace topobag {
inline namespace v0 {

/// A depth source over a depth image, 16-bit or float, one channel; it holds on to the image's
/// pixels. A disparity image of OpenCV's matchers (CV_16S, scale 16) is read for `DisparityDepth`.
class DepthImage {
 public:
  /// @param depth_scale  value / depth_scale = metres (F of eq. 5)
  /// Throws InvalidValue for an image that is empty or of another type, or a scale not > 0.
  DepthImage(const cv::Mat& image, double depth_scale) : image_(image) {
    const auto stride = static_cast<std::ptrdiff_t>(image.empty() ? 0 : image.step1());
    if (image.type() == CV_16UC1) {
      integers_.emplace(image.ptr<std::uint16_t>(), image.cols, image.rows, depth_scale, stride);
    } else if (image.type() == CV_16SC1) {
      disparities_.emplace(image.ptr<std::int16_t>(), image.cols, image.rows, depth_scale, stride);
    } else if (image.type() == CV_32FC1) {
      floats_.emplace(image.ptr<float>(), image.cols, image.rows, depth_scale, stride);
    } else {
      throw InvalidValue("a depth image has one channel, 16-bit integer or 32-bit float");
    }
  }

  /// px
  int width() const noexcept { return image_.cols; }
  /// px
  int height() const noexcept { return image_.rows; }

  /// Depth at the pixel nearest to (u, v), m. O(1).
  std::optional<double> operator()(const Eigen::Vector2d& pixel) const noexcept {
    if (integers_) return (*integers_)(pixel);
    return disparities_ ? (*disparities_)(pixel) : (*floats_)(pixel);
  }

 private:
  cv::Mat image_;  ///< shares the pixels
  std::optional<DepthView<std::uint16_t>> integers_;
  std::optional<DepthView<std::int16_t>> disparities_;
  std::optional<DepthView<float>> floats_;
};

}  // namespace v0
}  // namespace topobag
