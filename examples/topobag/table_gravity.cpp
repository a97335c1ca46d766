// SPDX-License-Identifier: MIT
#include "table_gravity.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

namespace program {
namespace {

constexpr double degree = 0.017453292519943295;  // rad
constexpr double least_deviation = 0.1 * degree;

/// Turned about an axis across it by two angles, rad.
Eigen::Vector3d tilted(const Eigen::Vector3d& down, double a, double b) {
  const double angle = std::hypot(a, b);
  if (angle == 0.0) return down;
  const Eigen::Vector3d u = down.unitOrthogonal(), v = down.cross(u);
  return Eigen::AngleAxisd(angle, (a * u + b * v) / angle) * down;
}

}  // namespace

void apply(const TableGravity& gravity, Draws draws, NodeTable& table) {
  if (!gravity.world_up) return;
  const Eigen::Vector3d& up = *gravity.world_up;
  const Eigen::Vector3d down = -(up / up.cwiseAbs().maxCoeff()).normalized();
  const double noise = gravity.noise * degree;
  for (FrameRow& frame : table.frames) {
    const double a = noise * draws.normal();
    const double b = noise * draws.normal();
    if (!frame.T_world_camera) continue;
    const Eigen::Vector3d in_camera = frame.T_world_camera->linear().transpose() * down;
    frame.gravity = topobag::Gravity<>{tilted(in_camera, a, b), std::max(noise, least_deviation)};
  }
}

}  // namespace program
