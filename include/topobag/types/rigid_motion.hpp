// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
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

/// What else than turn and move a transformation does; empty for a rigid motion.
inline std::string unrigid_part(const Eigen::Matrix4d& T, double tolerance) {
  if (!T.allFinite()) return "a number of it is not finite";
  if (T.row(3) != Eigen::RowVector4d(0.0, 0.0, 0.0, 1.0)) {
    return "its last row is not 0 0 0 1; is it transposed?";
  }
  const Eigen::Matrix3d R = T.topLeftCorner<3, 3>();
  const Eigen::Matrix3d product = R * R.transpose();
  const double square = product.trace() / 3.0;  // of its scale
  const bool unscaled = (product - Eigen::Matrix3d::Identity()).norm() <= tolerance;
  if (!unscaled && square > 0.0 &&
      (product / square - Eigen::Matrix3d::Identity()).norm() <= tolerance) {
    return "it scales by " + std::to_string(std::sqrt(square)) + "; divide the rotation by that";
  }
  if (!unscaled) return "the columns of its rotation are not at right angles and of length 1";
  if (R.determinant() < 0.0) return "it mirrors; one of the two frames is left-handed";
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
