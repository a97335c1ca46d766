// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <topobag/error.hpp>

namespace topobag {
inline namespace v0 {

/// In which order a pixel's three bytes stand.
enum class ColorOrder { rgb, bgr };

/// The memory of a colour image, 8 bits a channel, which must outlive the view; nothing is copied.
class ImageView {
 public:
  /// Red, green and blue.
  using Color = std::array<std::uint8_t, 3>;

  /// @param data          row-major pixels
  /// @param width,height  px
  /// @param row_stride    bytes from one row to the next; 0 = no gaps
  /// @param channels      bytes of a pixel; those after the third are passed over
  /// Throws InvalidValue for a null image, a size below 1, fewer than 3 channels, or a stride below
  /// a row's bytes.
  ImageView(const std::uint8_t* data, int width, int height, ColorOrder order,
            std::ptrdiff_t row_stride = 0, int channels = 3)
      : data_(data),
        width_(width),
        height_(height),
        channels_(channels),
        row_stride_(row_stride == 0 ? std::ptrdiff_t{width} * channels : row_stride),
        red_(order == ColorOrder::rgb ? 0 : 2) {
    if (data == nullptr || width < 1 || height < 1) throw InvalidValue("the image is empty");
    if (channels < 3) throw InvalidValue("a colour image has three channels at least");
    if (row_stride_ < std::ptrdiff_t{width} * channels) {
      throw InvalidValue("the image's row stride is below its row's bytes");
    }
  }

  /// px
  int width() const noexcept { return width_; }
  /// px
  int height() const noexcept { return height_; }

  /// The pixel's colour. Precondition: it lies in the image. O(1).
  Color operator()(int column, int row) const noexcept {
    const std::uint8_t* pixel = data_ + row * row_stride_ + std::ptrdiff_t{column} * channels_;
    return {pixel[red_], pixel[1], pixel[2 - red_]};
  }

 private:
  const std::uint8_t* data_;
  int width_;
  int height_;
  int channels_;
  std::ptrdiff_t row_stride_;
  std::ptrdiff_t red_;  ///< where it stands in a pixel
};

}  // namespace v0
}  // namespace topobag
