// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <topobag/types/detail/one_alignment.hpp>
#include <topobag/version.hpp>

namespace topobag {
inline namespace v0 {

/// On which side of a pose T_a_b its error ξ stands, and so in whose frame it is told.
enum class ErrorSide {
  left,   ///< T_true = Exp(ξ) · T_a_b: ξ is in frame a
  right,  ///< T_true = T_a_b · Exp(ξ): ξ is in frame b
};

/// How the six numbers of ξ follow each other: translation in m, rotation vector in rad.
enum class ErrorOrder {
  translation_rotation,  ///< topobag and g2o
  rotation_translation,  ///< GTSAM
};

/// The matrix that takes errors in frame b, (translation, rotation), to those in frame a:
/// T · Exp(ξ) = Exp(Ad(T) · ξ) · T. (Barfoot, State Estimation for Robotics, 7.45.)
inline Eigen::Matrix<double, 6, 6> adjoint(const Eigen::Isometry3d& T_a_b) {
  const Eigen::Matrix3d R = T_a_b.linear();
  const Eigen::Vector3d t = T_a_b.translation();
  Eigen::Matrix<double, 6, 6> result = Eigen::Matrix<double, 6, 6>::Zero();
  result.topLeftCorner<3, 3>() = result.bottomRightCorner<3, 3>() = R;
  for (Eigen::Index i = 0; i < 3; ++i) result.col(3 + i).head<3>() = t.cross(R.col(i));
  return result;
}

/// A pose T_a_b and how uncertain it is. The type says how the covariance is to be read; `as` takes
/// it to another reading. To first order in the error, as every covariance of a pose is.
///
///     const auto factor = pose.as<GtsamPose>();  // factor.T, factor.covariance
template <ErrorSide Side = ErrorSide::left, ErrorOrder Order = ErrorOrder::translation_rotation>
struct PoseWithCovariance {
  using Matrix6 = Eigen::Matrix<double, 6, 6>;

  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();  ///< takes coordinates in b to a
  Matrix6 covariance = Matrix6::Zero();                 ///< of ξ; zero: exact

  /// A pose alone, where that is asked for.
  operator const Eigen::Isometry3d&() const noexcept { return T; }

  /// The same in another reading.
  /// @tparam Other  a `PoseWithCovariance`
  template <typename Other>
  Other as() const {
    return Other::from_left(T, left_covariance());
  }

  /// T_b_a.
  PoseWithCovariance inverse() const {
    // (Exp(ξ) · T)⁻¹ = T⁻¹ · Exp(−ξ): what was left of the pose is right of its inverse.
    const Matrix6 Ad = adjoint(T.inverse());
    return from_left(T.inverse(), Ad * left_covariance() * Ad.transpose());
  }

  /// In the reading that all computing is done in: left, (translation, rotation).
  Matrix6 left_covariance() const {
    const Matrix6 ordered = reordered(covariance);
    if constexpr (Side == ErrorSide::left) return ordered;
    const Matrix6 Ad = adjoint(T);
    return Ad * ordered * Ad.transpose();
  }

  /// From that reading.
  static PoseWithCovariance from_left(const Eigen::Isometry3d& T, const Matrix6& left_covariance) {
    if constexpr (Side == ErrorSide::left) return {T, reordered(left_covariance)};
    const Matrix6 Ad = adjoint(T.inverse());
    return {T, reordered(Ad * left_covariance * Ad.transpose())};
  }

 private:
  /// Between `Order` and (translation, rotation), either way.
  static Matrix6 reordered(const Matrix6& matrix) {
    if constexpr (Order == ErrorOrder::translation_rotation) return matrix;
    Matrix6 swapped;
    swapped << matrix.bottomRightCorner<3, 3>(), matrix.bottomLeftCorner<3, 3>(),
        matrix.topRightCorner<3, 3>(), matrix.topLeftCorner<3, 3>();
    return swapped;
  }
};

/// T_a_c of T_a_b and T_b_c, whose errors are independent.
template <ErrorSide Side, ErrorOrder Order>
PoseWithCovariance<Side, Order> operator*(const PoseWithCovariance<Side, Order>& T_a_b,
                                          const PoseWithCovariance<Side, Order>& T_b_c) {
  // Exp(ξ₁) · T₁ · Exp(ξ₂) · T₂ = Exp(ξ₁) · Exp(Ad(T₁) · ξ₂) · T₁ · T₂
  const Eigen::Matrix<double, 6, 6> Ad = adjoint(T_a_b.T);
  return PoseWithCovariance<Side, Order>::from_left(
      T_a_b.T * T_b_c.T, T_a_b.left_covariance() + Ad * T_b_c.left_covariance() * Ad.transpose());
}

/// As the noise of GTSAM's factors over `Pose3`.
using GtsamPose = PoseWithCovariance<ErrorSide::right, ErrorOrder::rotation_translation>;
/// As the error of g2o's `EdgeSE3`, but for its rotation, which g2o tells in half angles
/// (`evaluation/g2o_text.hpp` writes that).
using G2oPose = PoseWithCovariance<ErrorSide::right, ErrorOrder::translation_rotation>;

}  // namespace v0
}  // namespace topobag
