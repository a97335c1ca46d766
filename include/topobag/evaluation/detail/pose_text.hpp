// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include <Eigen/Geometry>

#include <topobag/evaluation/detail/text_lines.hpp>
#include <topobag/evaluation/trajectory.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// How far a quaternion's norm, or a rotation matrix's product with its transpose, may be from one
/// before a reader refuses it instead of normalising it: room for text with two decimals.
inline constexpr double rotation_tolerance = 0.01;

template <typename Lines>
void require_finite(const Lines& lines, const double* values, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    if (!std::isfinite(values[i])) lines.fail("a number is not finite.");
  }
}

/// `tx ty tz qx qy qz qw` of the current line as a pose.
template <typename Lines>
Eigen::Isometry3d pose_from_quaternion(const Lines& lines, const double* values) {
  require_finite(lines, values, 7);
  const Eigen::Quaterniond q(values[6], values[3], values[4], values[5]);
  if (!(std::abs(q.norm() - 1.0) <= rotation_tolerance)) {
    lines.fail("the quaternion (the last four numbers, qx qy qz qw) does not have unit length.");
  }
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() << values[0], values[1], values[2];
  pose.linear() = q.normalized().toRotationMatrix();
  return pose;
}

/// A row-major 3×4 matrix [R | t] of the current line as a pose.
template <typename Lines>
Eigen::Isometry3d pose_from_matrix(const Lines& lines, const double* values) {
  require_finite(lines, values, 12);
  const Eigen::Map<const Eigen::Matrix<double, 3, 4, Eigen::RowMajor>> matrix(values);
  const Eigen::Matrix3d rotation = matrix.leftCols<3>();
  const double defect = (rotation * rotation.transpose() - Eigen::Matrix3d::Identity()).norm();
  if (!(defect <= rotation_tolerance) || rotation.determinant() < 0.0) {
    lines.fail("the first three columns of the 3×4 matrix are not a rotation.");
  }
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() = matrix.col(3);
  pose.linear() = Eigen::Quaterniond(rotation).normalized().toRotationMatrix();
  return pose;
}

}  // namespace detail
}  // namespace v0
}  // namespace topobag
