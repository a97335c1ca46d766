// SPDX-License-Identifier: MIT
#include "trajectory_array.hpp"

#include <topobag/types/rigid_motion.hpp>

namespace python {

py::array_t<double> matrices_of(const std::vector<Eigen::Isometry3d>& poses) {
  py::array_t<double> matrices(
      {static_cast<py::ssize_t>(poses.size()), py::ssize_t{4}, py::ssize_t{4}});
  double* out = matrices.mutable_data();
  for (const Eigen::Isometry3d& pose : poses) {
    for (int i = 0; i < 16; ++i) *out++ = pose(i / 4, i % 4);
  }
  return matrices;
}

std::vector<Eigen::Isometry3d> poses_from(const ArrayLike& matrices, const std::string& name) {
  const auto given = numbers(matrices, name, {any, 4, 4});
  const auto entry = given.unchecked<3>();
  std::vector<Eigen::Isometry3d> poses;
  for (py::ssize_t i = 0; i < given.shape(0); ++i) {
    Eigen::Isometry3d& pose = poses.emplace_back();
    for (int k = 0; k < 16; ++k) pose.matrix()(k / 4, k % 4) = entry(i, k / 4, k % 4);
    topobag::require_rigid(pose, "pose " + std::to_string(i) + " of " + name);
  }
  return poses;
}

}  // namespace python
