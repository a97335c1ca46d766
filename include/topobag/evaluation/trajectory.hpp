// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include <Eigen/Geometry>

#include <topobag/types/detail/one_alignment.hpp>
#include <topobag/version.hpp>

namespace topobag {
inline namespace v0 {

/// Where a body (mostly a camera) was at one moment.
struct StampedPose {
  double stamp = 0.0;                                             ///< time, s
  Eigen::Isometry3d T_world_body{Eigen::Isometry3d::Identity()};  ///< body to world, m
};

/// Poses by strictly increasing time, as every reader returns them.
using Trajectory = std::vector<StampedPose>;

/// How a rotation between two poses is interpolated.
enum class RotationInterpolation {
  slerp,  ///< spherical, along the shorter arc
  /// As the OpenLORIS-Scene benchmark's script does it, for numbers that compare with those
  /// published: linear between near rotations; between others it takes each end's spherical weight
  /// for the other end, and an inner product that counts the second w twice. In fast turns that is
  /// off by up to the turn between the two poses; the benchmark's AOE differs from `slerp`'s by up
  /// to 0.08°.
  openloris,
};

namespace detail {

/// The sign that makes the largest component positive.
template <typename Derived>
Eigen::Quaterniond with_canonical_sign(const Eigen::QuaternionBase<Derived>& q) {
  Eigen::Index largest = 0;
  q.coeffs().cwiseAbs().maxCoeff(&largest);
  return Eigen::Quaterniond(q.coeffs()[largest] < 0.0 ? Eigen::Vector4d(-q.coeffs()) : q.coeffs());
}

/// `RotationInterpolation::openloris`, at `alpha` of the way.
template <typename From, typename To>
Eigen::Quaterniond openloris_slerp(const Eigen::QuaternionBase<From>& from,
                                   const Eigen::QuaternionBase<To>& to, double alpha) {
  const Eigen::Quaterniond a = with_canonical_sign(from);
  Eigen::Quaterniond b = with_canonical_sign(to);
  double inner = a.vec().dot(b.vec()) + b.w() * b.w();
  if (inner < 0.0) {
    b.coeffs() = -b.coeffs();
    inner = -inner;
  }
  double weight_a = 1.0 - alpha;
  double weight_b = alpha;
  if (inner <= 0.99999) {
    const double sine = std::sqrt(1.0 - inner * inner);
    const double angle = std::atan2(sine, inner);
    weight_a = std::sin(alpha * angle) / sine;
    weight_b = std::sin((1.0 - alpha) * angle) / sine;
  }
  return Eigen::Quaterniond(weight_a * a.coeffs() + weight_b * b.coeffs()).normalized();
}

}  // namespace detail

/// The pose at `alpha` of the way from `a` to `b`, the position linear.
/// @param a,b  each an `Eigen::Isometry3d`
template <typename PoseA, typename PoseB>
Eigen::Isometry3d interpolate(const PoseA& a, const PoseB& b, double alpha,
                              RotationInterpolation rule = RotationInterpolation::slerp) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() = (1.0 - alpha) * a.translation() + alpha * b.translation();
  const Eigen::Quaterniond from(a.linear());
  const Eigen::Quaterniond to(b.linear());
  const Eigen::Quaterniond q = rule == RotationInterpolation::slerp
                                   ? from.slerp(alpha, to).normalized()
                                   : detail::openloris_slerp(from, to, alpha);
  pose.linear() = q.toRotationMatrix();
  return pose;
}

/// The pose at a time between two poses that are each less than `max_gap_s` away from it; nothing
/// outside the trajectory or in a larger gap. O(log n).
/// @param trajectory  a `Trajectory`, or other sorted `StampedPose` with random access
template <typename Poses = Trajectory>
std::optional<Eigen::Isometry3d> pose_at(
    const Poses& trajectory, double stamp, double max_gap_s,
    RotationInterpolation rule = RotationInterpolation::slerp) {
  const auto after =
      std::lower_bound(trajectory.begin(), trajectory.end(), stamp,
                       [](const StampedPose& pose, double t) { return pose.stamp < t; });
  if (after == trajectory.end()) return std::nullopt;
  if (after->stamp == stamp) return after->T_world_body;
  if (after == trajectory.begin()) return std::nullopt;
  const auto before = after - 1;
  const double since = stamp - before->stamp;
  const double until = after->stamp - stamp;
  if (!(std::max(since, until) < max_gap_s)) return std::nullopt;
  return interpolate(before->T_world_body, after->T_world_body, since / (since + until), rule);
}

/// The trajectory of another frame that is fixed to the body: every pose times `T_body_frame`.
/// @param trajectory  a `Trajectory`, or another range of `StampedPose`
template <typename Poses = Trajectory>
Poses in_frame(Poses trajectory, const Eigen::Isometry3d& T_body_frame) {
  for (auto& pose : trajectory) pose.T_world_body = pose.T_world_body * T_body_frame;
  return trajectory;
}

}  // namespace v0
}  // namespace topobag
