// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <topobag/matching/relative_pose.hpp>
#include <topobag/types/pose_with_covariance.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// A Sim(3) from frame b, in a unit of its own, to frame a, x_a = T · (scale · x_b), and how
/// uncertain it is: by the error ζ = (translation, rotation, logarithm of the scale) in frame a,
/// true = Exp(ζ) · this. ζ moves a point x by ρ + ω × x + λ x.
///
/// (Strasdat, Local Accuracy and Global Consistency for Efficient Visual SLAM, 2012, 2.4.)
struct Sim3WithCovariance {
  using Vector7 = Eigen::Matrix<double, 7, 1>;
  using Matrix7 = Eigen::Matrix<double, 7, 7>;

  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();  ///< in a's unit
  double scale = 1.0;                                   ///< a's units in one of b's
  Matrix7 covariance = Matrix7::Zero();                 ///< of ζ

  /// Takes the error (ξ, λ) of a pose T and a scale beside it, T_true = Exp(ξ) · T, to ζ: the scale
  /// then leaves b's origin where it is, and not a's.
  static Matrix7 from_pose_and_scale(const Eigen::Isometry3d& T) {
    Matrix7 to_zeta = Matrix7::Identity();
    to_zeta.topRightCorner<3, 1>() = -T.translation();
    return to_zeta;
  }

  /// From the query's frame to the candidate's.
  static Sim3WithCovariance of(const RelativePose& pose) {
    Matrix7 apart;
    const double deviation = pose.scale_deviation / pose.scale;
    apart << pose.covariance, pose.scale_covariance, pose.scale_covariance.transpose(),
        deviation * deviation;
    const Matrix7 to_zeta = from_pose_and_scale(pose.T_candidate_query);
    return {pose.T_candidate_query, pose.scale, to_zeta * apart * to_zeta.transpose()};
  }

  /// Of the pose and the scale beside each other, (ξ, λ).
  Matrix7 of_pose_and_scale() const {
    const Matrix7 from_zeta = 2.0 * Matrix7::Identity() - from_pose_and_scale(T);
    return from_zeta * covariance * from_zeta.transpose();
  }

  /// This · Exp(ζ) = Exp(Ad · ζ) · this.
  Matrix7 adjoint() const {
    Matrix7 Ad = Matrix7::Zero();
    Ad.topLeftCorner<6, 6>() = v0::adjoint(T);
    Ad.topLeftCorner<3, 3>() *= scale;
    Ad.topRightCorner<3, 1>() = -T.translation();
    Ad(6, 6) = 1.0;
    return Ad;
  }

  /// What a point of b is in a.
  Eigen::Vector3d operator*(const Eigen::Vector3d& x_b) const { return T * (scale * x_b); }
};

/// Of a, b and c, where the errors are independent.
inline Sim3WithCovariance operator*(const Sim3WithCovariance& a_b, const Sim3WithCovariance& b_c) {
  Eigen::Isometry3d T = a_b.T;
  T.linear() = a_b.T.linear() * b_c.T.linear();
  T.translation() = a_b * Eigen::Vector3d(b_c.T.translation());
  const Sim3WithCovariance::Matrix7 Ad = a_b.adjoint();
  return {T, a_b.scale * b_c.scale, a_b.covariance + Ad * b_c.covariance * Ad.transpose()};
}

}  // namespace detail
}  // namespace v0
}  // namespace topobag
