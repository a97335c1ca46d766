// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include <opencv2/core.hpp>

#include <topobag/error.hpp>
#include <topobag/sensing/image_view.hpp>

namespace topobag {
inline namespace v0 {

/// A view of a colour image of 8 bits a channel, which must outlive it; of four channels the last
/// is passed over.
/// @param order  OpenCV reads images as BGR
/// Throws InvalidValue for an image that is empty or of another type.
inline ImageView color_image(const cv::Mat& image, ColorOrder order = ColorOrder::bgr) {
  if (image.type() != CV_8UC3 && image.type() != CV_8UC4) {
    throw InvalidValue("a colour image has three or four channels of 8 bits");
  }
  return ImageView(image.data, image.cols, image.rows, order,
                   static_cast<std::ptrdiff_t>(image.step[0]), image.channels());
}

}  // namespace v0
}  // namespace topobag
