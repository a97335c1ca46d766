// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <Eigen/LU>

#include <topobag/matching/detail/real_roots.hpp>
#include <topobag/types/detail/one_alignment.hpp>

namespace topobag {
inline namespace v0 {

/// Three points or three directions, in matching order.
using ThreeVectors = std::array<Eigen::Vector3d, 3>;

/// Of the third point's range to the first one's: where it is known, fewer answers are worked out.
struct RangeRatio {
  double least = 1e-3;    ///< positive
  double greatest = 1e3;  ///< more than `least`
};

namespace detail {

/// How far away three points of known mutual distances are, seen under known angles.
template <typename Vectors>
class ThreeRanges {
 public:
  ThreeRanges(const Vectors& points, const Vectors& bearings) {
    for (std::size_t i = 0; i < 3; ++i) {  // the pair that leaves point i out
      const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
      squared_[i] = (points[j] - points[k]).squaredNorm();
      cosine_[i] = bearings[j].dot(bearings[k]);
    }
  }

  /// All solutions, m, each of three positive ranges.
  std::vector<Eigen::Vector3d> solutions(const RangeRatio& ratio) const {
    // Ranges are told by the first: (1, u, v) · s. The three laws of cosines less s² are two
    // conics in u and v, in whose difference u is linear; that put into the second is a quartic.
    const double q = (squared_[0] - squared_[2]) / squared_[1];
    const double r = squared_[2] / squared_[1];
    const std::array<double, 3> law{1.0, -2.0 * cosine_[1], 1.0};  // of the first and the third
    std::array<double, 3> n{-1.0 - q * law[0], -q * law[1], 1.0 - q * law[2]};
    std::array<double, 2> d{-2.0 * cosine_[2], 2.0 * cosine_[0]};  // u = n / d
    const std::array<double, 3> rest{1.0 - r * law[0], -r * law[1], -r * law[2]};
    Quartic p{};
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) p[i + j] += n[i] * n[j];
      for (std::size_t j = 0; j < 2; ++j) {
        p[i + j] -= 2.0 * cosine_[2] * n[i] * d[j];
        for (std::size_t k = 0; k < 2; ++k) p[i + j + k] += rest[i] * d[j] * d[k];
      }
    }
    std::vector<Eigen::Vector3d> found;
    for (const double v : real_roots(p, ratio.least, ratio.greatest)) {
      const double numerator = n[0] + v * (n[1] + v * n[2]), denominator = d[0] + v * d[1];
      const double right = rest[0] + v * (rest[1] + v * rest[2]);
      if (std::abs(denominator) > 1e-7) {
        offer(numerator / denominator, v, found);
      } else {  // u is open in the difference, and told by the second: u² − 2 u cos + right = 0
        const double root = std::sqrt(std::max(0.0, cosine_[2] * cosine_[2] - right));
        offer(cosine_[2] + root, v, found);
        offer(cosine_[2] - root, v, found);
      }
    }
    return found;
  }

 private:
  /// Polishes a solution and takes it if it is one, and new.
  void offer(double u, double v, std::vector<Eigen::Vector3d>& found) const {
    const double across = 1.0 + v * v - 2.0 * v * cosine_[1];
    if (!(u > 0.0) || !(across > 0.0)) return;
    Eigen::Vector3d s = std::sqrt(squared_[1] / across) * Eigen::Vector3d(1.0, u, v);
    const int steps = 12;  // a double root is approached by halves
    for (int step = 0; step < steps; ++step) {
      Eigen::Vector3d error;
      Eigen::Matrix3d slope = Eigen::Matrix3d::Zero();
      for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        const auto at = static_cast<std::size_t>(i);
        error(i) = s(j) * s(j) + s(k) * s(k) - 2.0 * s(j) * s(k) * cosine_[at] - squared_[at];
        slope(i, j) = 2.0 * (s(j) - s(k) * cosine_[at]);
        slope(i, k) = 2.0 * (s(k) - s(j) * cosine_[at]);
      }
      if (error.norm() <= 1e-14 * squared_[1]) break;
      const Eigen::Vector3d change = slope.inverse() * error;
      if (!change.allFinite() || change.norm() > 0.5 * s.norm()) break;
      s -= change;
    }
    const auto same = [&](const Eigen::Vector3d& other) {
      return (other - s).norm() <= 1e-6 * s.norm();
    };
    if (!(s.minCoeff() > 0.0) || worst_error(s) > 1e-8) return;
    if (std::none_of(found.begin(), found.end(), same)) found.push_back(s);
  }

  /// Of the three squared distances, as a share of the longest.
  double worst_error(const Eigen::Vector3d& s) const {
    double worst = 0.0;
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      const auto at = static_cast<std::size_t>(i);
      const double across = s(j) * s(j) + s(k) * s(k) - 2.0 * s(j) * s(k) * cosine_[at];
      worst = std::max(worst, std::abs(across - squared_[at]));
    }
    return worst / std::max({squared_[0], squared_[1], squared_[2]});
  }

  std::array<double, 3> squared_{};  ///< m²
  std::array<double, 3> cosine_{};
};

/// The axes of a triangle: along its first side, across it in its plane, and its normal. Nothing
/// for three points on a line.
template <typename Vectors>
std::optional<Eigen::Matrix3d> triangle_axes(const Vectors& points) {
  const double least_sine = 1e-3;  // of the flattest triangle
  const Eigen::Vector3d a = points[1] - points[0], b = points[2] - points[0];
  const Eigen::Vector3d normal = a.cross(b);
  const double longest2 =
      std::max({a.squaredNorm(), b.squaredNorm(), (points[2] - points[1]).squaredNorm()});
  if (!(normal.norm() > least_sine * longest2)) return std::nullopt;
  Eigen::Matrix3d axes;
  axes.col(0) = a.normalized();
  axes.col(2) = normal.normalized();
  axes.col(1) = axes.col(2).cross(axes.col(0));
  return axes;
}

}  // namespace detail

/// Every pose of a camera that sees three points in three directions: at most four.
///
/// The perspective-three-point problem, by Grunert's quartic (1841; Haralick, Lee, Ottenberg,
/// Nölle, IJCV 1994, compare it with others), its solutions polished by Newton's method on the
/// ranges.
///
/// @param points    m, target frame
/// @param bearings  unit vectors in the camera's frame, parallel to `points`
/// @param ratio     within which the answers are looked for
/// Returned are T_target_camera. None for points nearly on a line, for two bearings that are nearly
/// one, and where no triangle of such sides is seen so. O(1).
template <typename Vectors = ThreeVectors>
std::vector<Eigen::Isometry3d> poses_from_three_bearings(const Vectors& points,
                                                         const Vectors& bearings,
                                                         const RangeRatio& ratio = {}) {
  std::vector<Eigen::Isometry3d> poses;
  const auto target_axes = detail::triangle_axes(points);
  const double least_angle = 1e-3;  // rad, between two bearings
  for (std::size_t i = 0; i < 3; ++i) {
    if (!((bearings[i] - bearings[(i + 1) % 3]).norm() > least_angle)) return poses;
  }
  if (!target_axes) return poses;
  for (const Eigen::Vector3d& ranges :
       detail::ThreeRanges<Vectors>(points, bearings).solutions(ratio)) {
    const Vectors seen{ranges(0) * bearings[0], ranges(1) * bearings[1], ranges(2) * bearings[2]};
    const auto axes = detail::triangle_axes(seen);
    if (!axes) continue;
    Eigen::Isometry3d T_target_camera = Eigen::Isometry3d::Identity();
    T_target_camera.linear() = *target_axes * axes->transpose();
    T_target_camera.translation() = points[0] - T_target_camera.linear() * seen[0];
    poses.push_back(T_target_camera);
  }
  return poses;
}

}  // namespace v0
}  // namespace topobag
