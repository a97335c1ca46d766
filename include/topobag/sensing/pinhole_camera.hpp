// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <optional>
#include <type_traits>

#include <Eigen/Core>

#include <topobag/error.hpp>
#include <topobag/types/detail/one_alignment.hpp>

namespace topobag {
inline namespace v0 {

/// A pinhole camera without distortion (rectified or undistorted pixels).
template <typename Scalar_ = double>
struct PinholeCamera {
  static_assert(std::is_floating_point_v<Scalar_>,
                "topobag: the scalar of a camera is a floating-point type.");

  using Scalar = Scalar_;
  using Vector2 = Eigen::Matrix<Scalar, 2, 1>;
  using Vector3 = Eigen::Matrix<Scalar, 3, 1>;

  Scalar fx = Scalar(0);  ///< focal length in u, px
  Scalar fy = Scalar(0);  ///< focal length in v, px
  Scalar cx = Scalar(0);  ///< principal point u, px
  Scalar cy = Scalar(0);  ///< principal point v, px
  int width = 0;          ///< image width, px; 0 = unknown
  int height = 0;         ///< image height, px; 0 = unknown

  /// Throws InvalidValue unless all is finite, the focal lengths positive and the sizes not
  /// negative.
  void validate() const {
    const bool finite =
        std::isfinite(fx) && std::isfinite(fy) && std::isfinite(cx) && std::isfinite(cy);
    if (!finite || !(fx > Scalar(0)) || !(fy > Scalar(0)) || width < 0 || height < 0) {
      throw InvalidValue("a camera needs finite fx, fy > 0, finite cx, cy and an image size >= 0");
    }
  }

  /// Eq. 5 for a depth Z in metres: the point in the camera frame, m.
  Vector3 back_project(const Vector2& pixel, Scalar z) const noexcept {
    return {(pixel.x() - cx) * z / fx, (pixel.y() - cy) * z / fy, z};
  }

  /// Eq. 5 to the letter: raw depth z and the depth image's scale F, Z = z / F.
  Vector3 back_project(const Vector2& pixel, Scalar raw_depth, Scalar depth_scale) const noexcept {
    return back_project(pixel, raw_depth / depth_scale);
  }

  /// The pixel of a point in the camera frame; nothing at or behind the camera (Z <= 0).
  std::optional<Vector2> project(const Vector3& point) const noexcept {
    if (!(point.z() > Scalar(0))) return std::nullopt;
    return Vector2{fx * point.x() / point.z() + cx, fy * point.y() / point.z() + cy};
  }

  /// Whether a pixel lies in the image, `margin` px away from its border. Needs the image size.
  bool in_image(const Vector2& pixel, Scalar margin = Scalar(0)) const noexcept {
    return pixel.x() >= margin && pixel.y() >= margin &&
           pixel.x() <= static_cast<Scalar>(width - 1) - margin &&
           pixel.y() <= static_cast<Scalar>(height - 1) - margin;
  }

  /// The same camera in another number type.
  template <typename Other>
  PinholeCamera<Other> cast() const {
    return {static_cast<Other>(fx),
            static_cast<Other>(fy),
            static_cast<Other>(cx),
            static_cast<Other>(cy),
            width,
            height};
  }
};

}  // namespace v0
}  // namespace topobag
