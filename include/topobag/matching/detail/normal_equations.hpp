// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <Eigen/LU>

#include <topobag/matching/point_pair.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// The normal equations H ξ = g of a pose, ξ = (translation, rotation) in the target's frame, in
/// blocks of 3 × 3: their inverses have a closed form, which costs a fraction of a 6 × 6
/// factorisation.
class NormalEquations {
 public:
  /// At the pose `T_target_source`, under a Geman–McClure kernel.
  /// @param kernel_width  standard deviations at which the kernel bends
  NormalEquations(const Eigen::Isometry3d& T_target_source, const std::vector<PointPair>& pairs,
                  double kernel_width) {
    for (const PointPair& pair : pairs) add(pair, T_target_source, kernel_width * kernel_width);
  }

  /// ξ.
  Eigen::Matrix<double, 6, 1> solution() const {
    const Elimination e = eliminated();
    const Eigen::Vector3d turn = e.turn_variance * (g_turn_ - e.lever.transpose() * g_shift_);
    Eigen::Matrix<double, 6, 1> xi;
    xi << e.inverse_shift * g_shift_ - e.lever * turn, turn;
    return xi;
  }

  /// H⁻¹.
  Eigen::Matrix<double, 6, 6> covariance() const {
    const Elimination e = eliminated();
    const Eigen::Matrix3d mixed = -e.lever * e.turn_variance;
    Eigen::Matrix<double, 6, 6> covariance;
    covariance << e.inverse_shift - mixed * e.lever.transpose(), mixed, mixed.transpose(),
        e.turn_variance;
    return covariance;
  }

 private:
  void add(const PointPair& pair, const Eigen::Isometry3d& T_target_source, double width2) {
    const Eigen::Vector3d moved = T_target_source * pair.source;
    const Eigen::Vector3d r = pair.target - moved;
    // The inverse of the covariance is adjugate / determinant; the columns of a symmetric matrix's
    // adjugate are cross products of its own.
    const Eigen::Matrix3d covariance = pair.covariance(T_target_source);
    Eigen::Matrix3d adjugate;
    adjugate.col(0) = covariance.col(1).cross(covariance.col(2));
    adjugate.col(1) = covariance.col(2).cross(covariance.col(0));
    adjugate.col(2) = covariance.col(0).cross(covariance.col(1));
    const double determinant = covariance.col(0).dot(adjugate.col(0));
    const Eigen::Vector3d adjugate_r = adjugate * r;
    const double bent = width2 / (width2 + r.dot(adjugate_r) / determinant);
    const double scale = bent * bent / determinant;
    const Eigen::Matrix3d weight = scale * adjugate;
    const Eigen::Vector3d pull = scale * adjugate_r;
    // The moved source point changes by (I, −[moved]×) · ξ, and [moved]× is a cross product.
    const Eigen::Matrix3d turned_weight = cross_columns(moved, weight);
    shift_ += weight;
    mixed_ += turned_weight.transpose();
    turn_ += cross_columns(moved, turned_weight.transpose());
    g_shift_ += pull;
    g_turn_ += moved.cross(pull);
  }

  static Eigen::Matrix3d cross_columns(const Eigen::Vector3d& v, const Eigen::Matrix3d& columns) {
    Eigen::Matrix3d result;
    for (Eigen::Index i = 0; i < 3; ++i) result.col(i) = v.cross(columns.col(i));
    return result;
  }

  /// What is left when the translation is eliminated.
  struct Elimination {
    Eigen::Matrix3d inverse_shift;
    Eigen::Matrix3d lever;  ///< translation = inverse_shift · g_shift − lever · rotation
    Eigen::Matrix3d turn_variance;  ///< inverse of the Schur complement
  };
  Elimination eliminated() const {
    const Eigen::Matrix3d inverse_shift = shift_.inverse();
    const Eigen::Matrix3d lever = inverse_shift * mixed_;
    return {inverse_shift, lever, (turn_ - mixed_.transpose() * lever).inverse()};
  }

  // Of a direction that no pair pins down, the variance is 10⁶.
  Eigen::Matrix3d shift_ = 1e-6 * Eigen::Matrix3d::Identity();
  Eigen::Matrix3d mixed_ = Eigen::Matrix3d::Zero();
  Eigen::Matrix3d turn_ = 1e-6 * Eigen::Matrix3d::Identity();
  Eigen::Vector3d g_shift_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d g_turn_ = Eigen::Vector3d::Zero();
};

}  // namespace detail
}  // namespace v0
}  // namespace topobag
