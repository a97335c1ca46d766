// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>

#include <Eigen/Core>

#include <topobag/error.hpp>
#include <topobag/types/detail/one_alignment.hpp>

namespace topobag {
inline namespace v0 {

/// A depth source is any callable `(const Eigen::Vector2d& pixel) -> std::optional<double>`: metres
/// along the optical axis, nothing where there is no measurement.
template <typename T>
inline constexpr bool is_depth_source_v =
    std::is_invocable_r_v<std::optional<double>, const T&, const Eigen::Vector2d&>;

namespace detail {

template <typename Depth, typename = void>
struct knows_size : std::false_type {};
template <typename Depth>
struct knows_size<Depth, std::void_t<decltype(std::declval<const Depth&>().width()),
                                     decltype(std::declval<const Depth&>().height())>>
    : std::true_type {};

}  // namespace detail

/// Throws InvalidValue when a depth source that knows its image's size, by `width()` and
/// `height()`, is of another size than the image whose pixels it is to be asked for, where that is
/// known: depth is registered to the image, pixel by pixel.
template <typename Depth>
void require_registered(const Depth& depth, int width, int height) {
  if constexpr (detail::knows_size<Depth>::value) {
    if (width == 0 || height == 0 || (depth.width() == width && depth.height() == height)) return;
    throw InvalidValue("the depth image is " + std::to_string(depth.width()) + " x " +
                       std::to_string(depth.height()) + " px, the camera's image " +
                       std::to_string(width) + " x " + std::to_string(height) +
                       ": register the depth to the image first");
  }
}

/// A depth source over the memory of a depth image, which must outlive it; nothing is copied.
///
/// `Pixel` is a 16-bit integer (signed where it is a disparity of OpenCV's matchers, in sixteenths)
/// or a floating-point type. 0, negative and non-finite values are holes; so is everything outside
/// the image. The depth at (u, v) is the nearest pixel's.
template <typename Pixel>
class DepthView {
  static_assert(std::is_same_v<Pixel, std::uint16_t> || std::is_same_v<Pixel, std::int16_t> ||
                    std::is_floating_point_v<Pixel>,
                "topobag: DepthView reads 16-bit or floating-point depth images.");

 public:
  /// @param data          row-major pixels
  /// @param width,height  px
  /// @param depth_scale   F of eq. 5: value / F = metres (5000 for TUM RGB-D, 1000 for most, 1
  ///                      where the values are metres)
  /// @param row_stride    pixels from one row to the next; 0 = width
  /// Throws InvalidValue for a null image, a size below 1, a stride below the width, or F not > 0.
  DepthView(const Pixel* data, int width, int height, double depth_scale,
            std::ptrdiff_t row_stride = 0)
      : data_(data),
        width_(width),
        height_(height),
        row_stride_(row_stride == 0 ? width : row_stride),
        metres_per_unit_(1.0 / depth_scale) {
    if (data == nullptr || width < 1 || height < 1) throw InvalidValue("the depth image is empty");
    if (row_stride_ < width) throw InvalidValue("the depth image's row stride is below its width");
    if (!(depth_scale > 0.0) || !std::isfinite(depth_scale)) {
      throw InvalidValue("the depth scale must be positive and finite");
    }
  }

  /// px
  int width() const noexcept { return width_; }
  /// px
  int height() const noexcept { return height_; }

  /// Depth at the pixel nearest to (u, v), m. O(1).
  std::optional<double> operator()(const Eigen::Vector2d& pixel) const noexcept {
    // Written so that NaN fails as well.
    if (!(pixel.x() >= -0.5 && pixel.y() >= -0.5 && pixel.x() < width_ - 0.5 &&
          pixel.y() < height_ - 0.5)) {
      return std::nullopt;
    }
    // Just below a half, the sum rounds up.
    const auto column = std::min(static_cast<std::ptrdiff_t>(std::floor(pixel.x() + 0.5)),
                                 width_ - std::ptrdiff_t{1});
    const auto row = std::min(static_cast<std::ptrdiff_t>(std::floor(pixel.y() + 0.5)),
                              height_ - std::ptrdiff_t{1});
    const double metres = static_cast<double>(data_[row * row_stride_ + column]) * metres_per_unit_;
    if (!(metres > 0.0) || !std::isfinite(metres)) return std::nullopt;
    return metres;
  }

 private:
  const Pixel* data_;
  int width_;
  int height_;
  std::ptrdiff_t row_stride_;
  double metres_per_unit_;
};

/// A view over a row-major Eigen matrix or map (rows = image rows); it must outlive the view.
template <typename Derived>
DepthView<typename Derived::Scalar> depth_view(const Eigen::PlainObjectBase<Derived>& image,
                                               double depth_scale) {
  static_assert(Derived::IsRowMajor,
                "topobag: a depth image must be stored row by row (Eigen::RowMajor).");
  return {image.derived().data(), static_cast<int>(image.cols()), static_cast<int>(image.rows()),
          depth_scale};
}

/// Not of a matrix that is gone when the view is read.
template <typename Derived>
DepthView<typename Derived::Scalar> depth_view(const Eigen::PlainObjectBase<Derived>&& image,
                                               double depth_scale) = delete;

/// The same over a map. Throws InvalidValue when a row has gaps.
template <typename Plain, int Options, typename Stride>
DepthView<typename Plain::Scalar> depth_view(const Eigen::Map<Plain, Options, Stride>& image,
                                             double depth_scale) {
  static_assert(Plain::IsRowMajor,
                "topobag: a depth image must be stored row by row (Eigen::RowMajor).");
  if (image.innerStride() != 1) throw InvalidValue("the depth image's pixels have gaps in a row");
  return {image.data(), static_cast<int>(image.cols()), static_cast<int>(image.rows()), depth_scale,
          image.outerStride()};
}

}  // namespace v0
}  // namespace topobag
