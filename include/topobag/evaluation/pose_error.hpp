// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include <Eigen/Geometry>

#include <topobag/assert.hpp>
#include <topobag/types/detail/one_alignment.hpp>
#include <topobag/version.hpp>

namespace topobag {
inline namespace v0 {

/// Degrees in a radian.
inline constexpr double degrees_per_radian = 57.295779513082320876798;

/// The angle of a rotation, degrees in [0, 180]. Exact near 0 and near 180, where the arccos of the
/// trace loses half of the digits.
template <typename Derived>
double rotation_angle_deg(const Eigen::QuaternionBase<Derived>& rotation) {
  const auto sine = static_cast<double>(rotation.vec().norm());
  const auto cosine = static_cast<double>(std::abs(rotation.w()));
  return 2.0 * std::atan2(sine, cosine) * degrees_per_radian;
}

/// The same of a rotation matrix.
template <typename Derived>
double rotation_angle_deg(const Eigen::MatrixBase<Derived>& rotation) {
  return rotation_angle_deg(Eigen::Quaternion<typename Derived::Scalar>(rotation));
}

/// How far an estimated pose is from the true one: the size of E = T_true⁻¹ · T_estimate.
struct PoseError {
  double translation_m = 0.0;  ///< ‖t(E)‖, m
  double rotation_deg = 0.0;   ///< angle of R(E), degrees in [0, 180]
};

/// The error of `T_estimate` against `T_true`, each an `Eigen::Isometry3d`; both map the same
/// source frame to the same target.
template <typename TruePose, typename EstimatedPose>
PoseError pose_error(const TruePose& T_true, const EstimatedPose& T_estimate) {
  const Eigen::Isometry3d error = T_true.inverse(Eigen::Isometry) * T_estimate;
  return {error.translation().norm(), rotation_angle_deg(error.linear())};
}

/// The limits between the three verdicts; each wrong limit is not below its correct limit.
struct PoseLimits {
  double correct_translation_m = 0.3;  ///< m; the most of a correct pose
  double correct_rotation_deg = 15.0;  ///< degrees; the most of a correct pose
  double wrong_translation_m = 1.0;    ///< m; a pose further off is wrong
  double wrong_rotation_deg = 45.0;    ///< degrees; a pose turned by more is wrong
};

/// What an accepted match is worth as a loop constraint.
enum class PoseVerdict { correct, imprecise, wrong };

/// Correct within both correct limits, wrong beyond either wrong limit, imprecise between.
inline PoseVerdict judge(const PoseError& error, const PoseLimits& limits = {}) {
  TOPOBAG_ASSERT(limits.wrong_translation_m >= limits.correct_translation_m);
  TOPOBAG_ASSERT(limits.wrong_rotation_deg >= limits.correct_rotation_deg);
  if (error.translation_m <= limits.correct_translation_m &&
      error.rotation_deg <= limits.correct_rotation_deg) {
    return PoseVerdict::correct;
  }
  const bool within = error.translation_m <= limits.wrong_translation_m &&
                      error.rotation_deg <= limits.wrong_rotation_deg;
  return within ? PoseVerdict::imprecise : PoseVerdict::wrong;
}

}  // namespace v0
}  // namespace topobag
