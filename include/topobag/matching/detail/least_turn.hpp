// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <topobag/types/detail/one_alignment.hpp>
#include <topobag/version.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// The rotation of least angle that carries one unit vector onto another; of opposite ones, by half
/// a turn about some axis that is square to both. In place of Eigen's `FromTwoVectors`, which
/// decomposes a matrix for the latter and takes a compiler seconds.
template <typename From, typename To>
Eigen::Matrix3d least_turn(const Eigen::MatrixBase<From>& from, const Eigen::MatrixBase<To>& to) {
  using Scalar = typename From::Scalar;
  const double cosine = std::max(-1.0, from.dot(to));
  if (cosine < -1.0 + 1e-12) {
    const auto pi = static_cast<double>(EIGEN_PI);
    return Eigen::AngleAxis<Scalar>(pi, from.unitOrthogonal()).toRotationMatrix();
  }
  const double twice_real = std::sqrt(2.0 * (1.0 + cosine));
  Eigen::Quaternion<Scalar> turn;
  turn.vec() = from.cross(to) / twice_real;
  turn.w() = 0.5 * twice_real;
  return turn.toRotationMatrix();
}

}  // namespace detail
}  // namespace v0
}  // namespace topobag
