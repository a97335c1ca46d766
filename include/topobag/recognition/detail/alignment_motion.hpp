// SPDX-License-Identifier: MIT
// What the consensus of two maps asks of the motion between them: of a rigid one, and of a Sim(3)
// where the other map's unit is not known.
#pragma once

#include <cmath>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <topobag/matching/relative_pose.hpp>
#include <topobag/recognition/detail/sim3_with_covariance.hpp>
#include <topobag/types/pose_with_covariance.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// Of a motion.
template <typename Motion>
inline constexpr int unknowns_v = static_cast<int>(decltype(Motion::covariance)::RowsAtCompileTime);

/// From the query's frame to the candidate's.
template <typename Motion>
Motion motion_of(const RelativePose& pose) {
  if constexpr (unknowns_v<Motion> == 7) {
    return Motion::of(pose);
  } else {
    return pose.with_covariance();
  }
}

/// a's units in one of b's.
inline double scale_of(const PoseWithCovariance<>&) noexcept { return 1.0; }
inline double scale_of(const Sim3WithCovariance& a_b) noexcept { return a_b.scale; }

/// Variance of its logarithm.
inline double log_scale_variance(const PoseWithCovariance<>&) noexcept { return 0.0; }
inline double log_scale_variance(const Sim3WithCovariance& a_b) { return a_b.covariance(6, 6); }

/// Where a camera of b stands in a.
template <typename Motion>
Eigen::Isometry3d camera_in(const Motion& a_b, Eigen::Isometry3d T_b_camera) {
  T_b_camera.translation() *= scale_of(a_b);
  return a_b.T * T_b_camera;
}

/// How a point of a moves with the motion's error.
template <typename Motion>
Eigen::Matrix<double, 3, unknowns_v<Motion>> moved_by_error(const Motion&,
                                                            const Eigen::Vector3d& x_a) {
  Eigen::Matrix<double, 3, unknowns_v<Motion>> moved;
  moved.template leftCols<3>().setIdentity();
  for (Eigen::Index i = 0; i < 3; ++i) moved.col(3 + i) = Eigen::Vector3d::Unit(i).cross(x_a);
  if constexpr (unknowns_v<Motion> == 7) moved.col(6) = x_a;
  return moved;
}

/// ξ with T = Exp(ξ), to the third order in the rotation.
inline Eigen::Matrix<double, 6, 1> logarithm(const Eigen::Isometry3d& T) {
  const Eigen::AngleAxisd turn(T.linear());
  const Eigen::Vector3d omega = turn.angle() * turn.axis(), t = T.translation();
  Eigen::Matrix<double, 6, 1> xi;
  xi << t - 0.5 * omega.cross(t) + omega.cross(omega.cross(t)) / 12.0, omega;
  return xi;
}

/// The error of `from` by which it would be `to`: to = Exp(error) · from. To the third order in
/// rotation and scale.
inline Eigen::Matrix<double, 6, 1> error_between(const PoseWithCovariance<>& to,
                                                 const PoseWithCovariance<>& from) {
  return logarithm(to.T * from.T.inverse());
}
inline Eigen::Matrix<double, 7, 1> error_between(const Sim3WithCovariance& to,
                                                 const Sim3WithCovariance& from) {
  const double ratio = to.scale / from.scale, lambda = std::log(ratio);
  const Eigen::Matrix3d R = to.T.linear() * from.T.linear().transpose();
  const Eigen::AngleAxisd turn(R);
  const Eigen::Vector3d omega = turn.angle() * turn.axis();
  const Eigen::Vector3d t = to.T.translation() - ratio * (R * from.T.translation());
  const auto generated = [&](const Eigen::Vector3d& x) -> Eigen::Vector3d {
    return lambda * x + omega.cross(x);
  };
  Eigen::Matrix<double, 7, 1> zeta;
  zeta << t - 0.5 * generated(t) + generated(generated(t)) / 12.0, omega, lambda;
  return zeta;
}

/// Corrects a motion by a small error of it.
template <typename Motion>
void correct(Motion& a_b, const Eigen::Matrix<double, unknowns_v<Motion>, 1>& error) {
  if constexpr (unknowns_v<Motion> == 7) {
    const double ratio = std::exp(error(6));
    a_b.T.translation() *= ratio;
    a_b.scale *= ratio;
  }
  const Eigen::Vector3d turn = error.template segment<3>(3);
  Eigen::Isometry3d move(Eigen::Translation3d(error.template head<3>()));
  if (turn.norm() > 0.0) move.rotate(Eigen::AngleAxisd(turn.norm(), turn.normalized()));
  a_b.T = move * a_b.T;
}

}  // namespace detail
}  // namespace v0
}  // namespace topobag
