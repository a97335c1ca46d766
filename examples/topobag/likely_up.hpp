// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <Eigen/Geometry>

namespace program {

/// Which way is up in a world that does not say it: cameras are mostly held upright, so it is the
/// world's axis nearest to the mean of their images' up. O(n).
inline Eigen::Vector3d likely_up(const std::vector<Eigen::Isometry3d>& T_world_camera) {
  Eigen::Vector3d up = Eigen::Vector3d::Zero();
  for (const Eigen::Isometry3d& pose : T_world_camera) up -= pose.linear().col(1);
  Eigen::Index axis = 0;
  up.cwiseAbs().maxCoeff(&axis);
  return (up[axis] < 0.0 ? -1.0 : 1.0) * Eigen::Vector3d::Unit(axis);
}

}  // namespace program
