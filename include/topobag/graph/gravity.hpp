// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include <topobag/error.hpp>
#include <topobag/types/detail/one_alignment.hpp>

namespace topobag {
inline namespace v0 {

/// Which way is down, as an accelerometer, an IMU or a camera's mount tells it. It says nothing of
/// where the camera is, nor which way it is turned about the vertical.
template <typename Scalar_ = double>
struct Gravity {
  using Scalar = Scalar_;
  using Vector3 = Eigen::Matrix<Scalar, 3, 1>;

  Vector3 down = Vector3::UnitY();  ///< unit vector in the frame of the graph, that of its camera
  Scalar deviation = Scalar(0.0174533);  ///< rad; σ of its tilt about each horizontal axis: 1°
};

/// The same with a `down` of length 1; a unit vector stays as it is, to the last bit. Throws
/// InvalidValue for a number that is not finite, a `down` of length 0, or a deviation that is not
/// above 0.
template <typename Scalar>
Gravity<Scalar> normalized(Gravity<Scalar> gravity) {
  if (!gravity.down.allFinite() || gravity.down.isZero(Scalar(0))) {
    throw InvalidValue("the direction of gravity is not finite, or has no length");
  }
  if (!std::isfinite(gravity.deviation) || !(gravity.deviation > Scalar(0))) {
    throw InvalidValue("the deviation of gravity is not a finite number above 0");
  }
  const Scalar rounding = 4 * std::numeric_limits<Scalar>::epsilon();
  if (!(std::abs(gravity.down.squaredNorm() - Scalar(1)) <= rounding)) {
    gravity.down /= gravity.down.cwiseAbs().maxCoeff();  // whose square no number is too large for
    gravity.down.normalize();
  }
  return gravity;
}

/// What several directions, all in one frame, say together: their information-weighted mean. Its
/// deviation shrinks as if `correlation` of the errors of any two were common to both, as an
/// accelerometer's bias and a mount's tilt are: however many agree, its root remains of one's own.
/// Nothing for none, and where they contradict each other: where their mean is shorter than a half.
/// O(n).
template <typename Scalar>
std::optional<Gravity<Scalar>> fused_gravity(const std::vector<Gravity<Scalar>>& directions,
                                             Scalar correlation) {
  if (directions.empty()) return std::nullopt;
  const Scalar least = std::min_element(directions.begin(), directions.end(), [](auto& a, auto& b) {
                         return a.deviation < b.deviation;
                       })->deviation;
  typename Gravity<Scalar>::Vector3 weighted = Gravity<Scalar>::Vector3::Zero();
  Scalar information(0), root_information(0);  // in units of the surest one's
  for (const Gravity<Scalar>& gravity : directions) {
    const Scalar root = least / gravity.deviation;
    weighted += root * root * gravity.down;
    information += root * root;
    root_information += root;
  }
  if (!(weighted.norm() > information / 2)) return std::nullopt;
  const Scalar alone = Scalar(1) / information;             // variance, were no error common
  const Scalar in_common = root_information / information;  // deviation, were all of them common
  return Gravity<Scalar>{
      weighted.normalized(),
      least * std::sqrt((Scalar(1) - correlation) * alone + correlation * in_common * in_common)};
}

}  // namespace v0
}  // namespace topobag
