// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <string>

#include <Eigen/Geometry>

#include <topobag/error.hpp>
#include <topobag/types/detail/one_alignment.hpp>

namespace topobag {
inline namespace v0 {

/// How far a rotation's product with its transpose may be from one (Frobenius norm) in a pose that
/// was computed: room for single precision and many products.
inline constexpr double computed_rotation_tolerance = 1e-3;
/// The same for a pose that was written down: room for text with two decimals.
inline constexpr double written_rotation_tolerance = 0.01;

namespace detail {

/// What else than turn and move a transformation does; empty for a rigid motion. Number by number:
/// every map compiles it.
inline std::string unrigid_part(const Eigen::Matrix4d& T, double tolerance) {
  for (Eigen::Index i = 0; i < 16; ++i) {
    if (!std::isfinite(T.data()[i])) return "a number of it is not finite";
  }
  for (Eigen::Index column = 0; column < 4; ++column) {
    if (T(3, column) == (column == 3 ? 1.0 : 0.0)) continue;
    return "its last row is not 0 0 0 1; is it transposed?";
  }
  std::array<double, 9> product{};  // of the rotation and its transpose
  double square = 0.0;              // of its scale
  for (Eigen::Index row = 0; row < 3; ++row) {
    for (Eigen::Index column = 0; column < 3; ++column) {
      double& sum = product[static_cast<std::size_t>(3 * row + column)];
      for (Eigen::Index k = 0; k < 3; ++k) sum += T(row, k) * T(column, k);
      if (row == column) square += sum / 3.0;
    }
  }
  const auto off_unit = [&](double scale) {
    double squares = 0.0;
    for (std::size_t i = 0; i < product.size(); ++i) {
      const double difference = product[i] / scale - (i % 4 == 0 ? 1.0 : 0.0);
      squares += difference * difference;
    }
    return std::sqrt(squares);
  };
  if (!(off_unit(1.0) <= tolerance)) {
    if (square > 0.0 && off_unit(square) <= tolerance) {
      return "it scales by " + std::to_string(std::sqrt(square)) + "; divide the rotation by that";
    }
    return "the columns of its rotation are not at right angles and of length 1";
  }
  const double determinant = T(0, 0) * (T(1, 1) * T(2, 2) - T(1, 2) * T(2, 1)) -
                             T(0, 1) * (T(1, 0) * T(2, 2) - T(1, 2) * T(2, 0)) +
                             T(0, 2) * (T(1, 0) * T(2, 1) - T(1, 1) * T(2, 0));
  if (determinant < 0.0) return "it mirrors; one of the two frames is left-handed";
  return {};
}

}  // namespace detail

/// Throws InvalidValue unless `T` turns and moves and does nothing else: what every pose is held
/// to, wherever it comes in.
/// @param T          an `Eigen::Transform` of 3 dimensions
/// @param what       begins the sentence: "the entry's pose"
/// @param tolerance  of the rotation
template <typename Transform>
void require_rigid(const Transform& T, const std::string& what,
                   double tolerance = computed_rotation_tolerance) {
  const std::string wrong = detail::unrigid_part(T.matrix().template cast<double>(), tolerance);
  if (!wrong.empty()) throw InvalidValue(what + " is no rigid motion: " + wrong);
}

/// The rigid motion nearest to a 4 × 4 matrix that is one within `tolerance`: what rounding left
/// askew is put right; what is askew by less than 1e-12 stays as it is, to the last bit. Throws as
/// `require_rigid`.
template <typename Matrix>
Eigen::Isometry3d nearest_rigid(const Matrix& matrix, const std::string& what, double tolerance) {
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.matrix() = matrix;
  if (detail::unrigid_part(T.matrix(), 1e-12).empty()) return T;
  require_rigid(T, what, tolerance);
  T.linear() = Eigen::Quaterniond(T.linear()).normalized().toRotationMatrix();
  return T;
}

/// The pose that `tx ty tz qx qy qz qw` write down, seven numbers. Throws InvalidValue for a number
/// that is not finite and a quaternion whose length is not 1 within `written_rotation_tolerance`.
/// @param v  what `v[0]` to `v[6]` can be asked of
template <typename Numbers>
Eigen::Isometry3d pose_from_numbers(const Numbers& v) {
  const Eigen::Vector3d t(v[0], v[1], v[2]);
  const Eigen::Quaterniond q(v[6], v[3], v[4], v[5]);
  if (!t.allFinite() || !q.coeffs().allFinite()) {
    throw InvalidValue("a number of the pose is not finite");
  }
  if (!(std::abs(q.norm() - 1.0) <= written_rotation_tolerance)) {
    throw InvalidValue(
        "the quaternion (the last four numbers, qx qy qz qw) does not have unit length, but " +
        std::to_string(q.norm()));
  }
  return Eigen::Translation3d(t) * q.normalized();
}

}  // namespace v0
}  // namespace topobag
