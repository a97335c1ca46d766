// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>

#include <Eigen/Core>

#include <topobag/types/detail/one_alignment.hpp>
#include <topobag/version.hpp>

namespace topobag {
inline namespace v0 {

/// A detector's box in continuous pixel coordinates: upper-left (x1, y1), lower-right (x2, y2).
/// The origin is the centre of the upper-left pixel, u to the right, v down.
struct BoundingBox {
  double x1 = 0.0;  ///< left edge, px
  double y1 = 0.0;  ///< upper edge, px
  double x2 = 0.0;  ///< right edge, px, > x1
  double y2 = 0.0;  ///< lower edge, px, > y1

  /// px
  double width() const noexcept { return x2 - x1; }
  /// px
  double height() const noexcept { return y2 - y1; }
  /// px²
  double area() const noexcept { return width() * height(); }

  /// Finite with x2 > x1 and y2 > y1.
  bool is_valid() const noexcept {
    return std::isfinite(x1) && std::isfinite(y1) && std::isfinite(x2) && std::isfinite(y2) &&
           x2 > x1 && y2 > y1;
  }

  /// Box centre (u, v), px: eq. 2.
  Eigen::Vector2d center() const noexcept { return {(x1 + x2) / 2.0, (y1 + y2) / 2.0}; }

  /// Whether the pixel lies in the box, its border included.
  bool contains(const Eigen::Vector2d& pixel) const noexcept {
    return pixel.x() >= x1 && pixel.x() <= x2 && pixel.y() >= y1 && pixel.y() <= y2;
  }

  /// px; a side nearer to the image's border than this is where the border cuts the object.
  static constexpr double cut_margin = 2.0;

  /// Whether the border of an image of so many pixels cuts the object.
  bool is_cut(double image_width, double image_height) const noexcept {
    return x1 < cut_margin || y1 < cut_margin || x2 > image_width - 1.0 - cut_margin ||
           y2 > image_height - 1.0 - cut_margin;
  }

  /// The part inside an image of so many pixels; not valid when nothing is left.
  BoundingBox clipped(double image_width, double image_height) const noexcept {
    return {std::max(x1, -0.5), std::max(y1, -0.5), std::min(x2, image_width - 0.5),
            std::min(y2, image_height - 0.5)};
  }
};

/// The box of size `width` × `height` around `center`, px.
inline BoundingBox box_around(const Eigen::Vector2d& center, double width, double height) noexcept {
  return {center.x() - width / 2.0, center.y() - height / 2.0, center.x() + width / 2.0,
          center.y() + height / 2.0};
}

/// Intersection over union of two valid boxes, in [0, 1].
inline double intersection_over_union(const BoundingBox& a, const BoundingBox& b) noexcept {
  const double w = std::min(a.x2, b.x2) - std::max(a.x1, b.x1);
  const double h = std::min(a.y2, b.y2) - std::max(a.y1, b.y1);
  if (w <= 0.0 || h <= 0.0) return 0.0;
  return w * h / (a.area() + b.area() - w * h);
}

}  // namespace v0
}  // namespace topobag
