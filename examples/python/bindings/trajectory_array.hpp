// SPDX-License-Identifier: MIT
#pragma once

#include <topobag/evaluation/trajectory.hpp>

#include "arrays.hpp"

namespace python {

/// A trajectory as Python has it: one object, with stamps and poses as arrays.
struct TrajectoryArray {
  topobag::Trajectory poses;
};

/// n × 4 × 4.
py::array_t<double> matrices_of(const std::vector<Eigen::Isometry3d>& poses);

/// Rigid motions from an n × 4 × 4 array. Throws InvalidValue.
std::vector<Eigen::Isometry3d> poses_from(const ArrayLike& matrices, const std::string& name);

}  // namespace python
