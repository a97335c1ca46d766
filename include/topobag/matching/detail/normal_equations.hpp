// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <Eigen/LU>

#include <topobag/types/detail/one_alignment.hpp>
#include <topobag/version.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// The normal equations H ξ = g of a pose, ξ = (translation, rotation) in the target's frame, in
/// blocks of 3 × 3: their inverses have a closed form, which costs a fraction of a 6 × 6
/// factorisation.
template <typename Scalar>
class NormalEquations {
  using Vector3 = Eigen::Matrix<Scalar, 3, 1>;
  using Matrix3 = Eigen::Matrix<Scalar, 3, 3>;
  using Matrix6 = Eigen::Matrix<Scalar, 6, 6>;
  using Pose = Eigen::Transform<Scalar, 3, Eigen::Isometry>;

 public:
  /// At the pose `T_target_source`, under a Geman–McClure kernel.
  /// @param pairs         a range of `PointPair`
  /// @param kernel_width  standard deviations at which the kernel bends
  template <typename Pairs>
  NormalEquations(const Pose& T_target_source, const Pairs& pairs, Scalar kernel_width) {
    for (const auto& pair : pairs) add(pair, T_target_source, kernel_width * kernel_width);
  }

  /// Adds what the vertical says of the rotation.
  template <typename Vertical>
  void add_vertical(const Vertical& vertical, const Pose& T_target_source) {
    const Vector3 down = vertical.target_down;
    const Matrix3 projection = down * down.transpose();
    const Matrix3 weight = (Matrix3::Identity() - projection) / vertical.variance;
    turn_ += weight;
    g_turn_ += weight * vertical.tilt(T_target_source.linear());
  }

  /// ξ.
  struct Solution {
    Vector3 translation, rotation;
  };
  Solution solution() const {
    const Elimination e = eliminated();
    const Vector3 turn = e.turn_variance * (g_turn_ - e.lever.transpose() * g_shift_);
    return {e.inverse_shift * g_shift_ - e.lever * turn, turn};
  }

  /// H⁻¹.
  Matrix6 covariance() const {
    const Elimination e = eliminated();
    const Matrix3 mixed = -e.lever * e.turn_variance;
    Matrix6 covariance;
    covariance << e.inverse_shift - mixed * e.lever.transpose(), mixed, mixed.transpose(),
        e.turn_variance;
    return covariance;
  }

 private:
  template <typename Pair>
  void add(const Pair& pair, const Pose& T_target_source, Scalar width2) {
    const Vector3 moved = T_target_source * pair.source;
    const Vector3 r = pair.target - moved;
    // The inverse of the covariance is adjugate / determinant; the columns of a symmetric matrix's
    // adjugate are cross products of its own.
    const Matrix3 covariance = pair.covariance(T_target_source);
    Matrix3 adjugate;
    adjugate.col(0) = covariance.col(1).cross(covariance.col(2));
    adjugate.col(1) = covariance.col(2).cross(covariance.col(0));
    adjugate.col(2) = covariance.col(0).cross(covariance.col(1));
    const Scalar determinant = covariance.col(0).dot(adjugate.col(0));
    const Vector3 adjugate_r = adjugate * r;
    const Scalar bent = width2 / (width2 + r.dot(adjugate_r) / determinant);
    const Scalar scale = bent * bent / determinant;
    const Matrix3 weight = scale * adjugate;
    const Vector3 pull = scale * adjugate_r;
    // The moved source point changes by (I, −[moved]×) · ξ, and [moved]× is a cross product.
    const Matrix3 turned_weight = cross_columns(moved, weight);
    shift_ += weight;
    mixed_ += turned_weight.transpose();
    turn_ += cross_columns(moved, turned_weight.transpose());
    g_shift_ += pull;
    g_turn_ += moved.cross(pull);
  }

  template <typename Columns>
  static Matrix3 cross_columns(const Vector3& v, const Eigen::MatrixBase<Columns>& columns) {
    Matrix3 result;
    for (Eigen::Index i = 0; i < 3; ++i) result.col(i) = v.cross(columns.col(i));
    return result;
  }

  /// What is left when the translation is eliminated.
  struct Elimination {
    Matrix3 inverse_shift;
    Matrix3 lever;          ///< translation = inverse_shift · g_shift − lever · rotation
    Matrix3 turn_variance;  ///< inverse of the Schur complement
  };
  Elimination eliminated() const {
    const Matrix3 inverse_shift = shift_.inverse();
    const Matrix3 lever = inverse_shift * mixed_;
    return {inverse_shift, lever, (turn_ - mixed_.transpose() * lever).inverse()};
  }

  // Of a direction that no pair pins down, the variance is 10⁶.
  Matrix3 shift_ = Scalar(1e-6) * Matrix3::Identity();
  Matrix3 mixed_ = Matrix3::Zero();
  Matrix3 turn_ = Scalar(1e-6) * Matrix3::Identity();
  Vector3 g_shift_ = Vector3::Zero();
  Vector3 g_turn_ = Vector3::Zero();
};

}  // namespace detail
}  // namespace v0
}  // namespace topobag
