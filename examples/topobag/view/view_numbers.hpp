// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include <Eigen/Core>

#include "json_output.hpp"

namespace program {

/// To a tenth of a millimetre or millisecond: finer than anything that is drawn.
inline double rounded(double value) { return std::round(value * 1e4) / 1e4; }

/// Appends a vector's numbers to a flat list.
template <typename Vector>
void append(Json& list, const Eigen::MatrixBase<Vector>& vector) {
  for (Eigen::Index i = 0; i < vector.size(); ++i) list.push_back(rounded(vector(i)));
}

}  // namespace program
