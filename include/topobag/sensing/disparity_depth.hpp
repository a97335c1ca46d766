// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <optional>
#include <utility>

#include <Eigen/Core>

#include <topobag/error.hpp>
#include <topobag/sensing/depth_view.hpp>

namespace topobag {
inline namespace v0 {

/// A depth source over the disparities of a rectified stereo pair: Z = f · b / d.
///
/// @tparam Disparity  callable `pixel -> std::optional<double>`, px; a `DepthView` of a disparity
///                    image with its scale is one: `DepthView<std::int16_t>` and 16 for the CV_16S
///                    of OpenCV's matchers
template <typename Disparity>
class DisparityDepth {
  static_assert(is_depth_source_v<Disparity>,
                "topobag: a source of disparities is callable as disparity(Eigen::Vector2d pixel) "
                "-> std::optional<double> pixels.");

 public:
  /// @param focal_length  of the rectified images, px
  /// @param baseline      m
  /// Throws InvalidValue unless both are positive and finite.
  DisparityDepth(Disparity disparity, double focal_length, double baseline)
      : disparity_(std::move(disparity)), scale_(focal_length * baseline) {
    if (!(focal_length > 0.0) || !(baseline > 0.0) || !std::isfinite(scale_)) {
      throw InvalidValue("a stereo pair's focal length and baseline must be positive and finite");
    }
  }

  /// Depth at the pixel, m; nothing where there is no disparity above 0.
  std::optional<double> operator()(const Eigen::Vector2d& pixel) const {
    const std::optional<double> disparity = disparity_(pixel);
    if (!disparity || !(*disparity > 0.0) || !std::isfinite(*disparity)) return std::nullopt;
    return scale_ / *disparity;
  }

 private:
  Disparity disparity_;
  double scale_;  ///< px · m
};

}  // namespace v0
}  // namespace topobag
