// SPDX-License-Identifier: MIT
#pragma once

#include <random>

#include <topobag/evaluation/trajectory.hpp>

namespace topobag_tests {

inline Eigen::Isometry3d random_pose(std::mt19937& random, double extent_m = 5.0) {
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  const auto draw = [&] { return unit(random); };
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.translation() = Eigen::Vector3d::NullaryExpr(draw) * extent_m;
  T.linear() = Eigen::Quaterniond(Eigen::Vector4d::NullaryExpr(draw)).normalized().matrix();
  return T;
}

/// n poses at 0, 0.1, 0.2, … s.
inline topobag::Trajectory random_trajectory(std::mt19937& random, int n) {
  topobag::Trajectory trajectory;
  for (int i = 0; i < n; ++i) trajectory.push_back({0.1 * i, random_pose(random)});
  return trajectory;
}

/// A pose by its translation (m) and its turn around z (degrees).
inline Eigen::Isometry3d planar_pose(double x, double y, double yaw_deg) {
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.translation() << x, y, 0.0;
  const double pi = 3.14159265358979323846;
  T.linear() = Eigen::AngleAxisd(yaw_deg * pi / 180.0, Eigen::Vector3d::UnitZ()).matrix();
  return T;
}

}  // namespace topobag_tests
