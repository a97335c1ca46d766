// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include <Eigen/Geometry>

namespace program {

/// tx ty tz qx qy qz qw, as the program writes a pose; m.
inline std::array<double, 7> pose_numbers(const Eigen::Isometry3d& pose) {
  const Eigen::Vector3d t = pose.translation();
  const Eigen::Quaterniond q(pose.linear());
  return {t.x(), t.y(), t.z(), q.x(), q.y(), q.z(), q.w()};
}

}  // namespace program
