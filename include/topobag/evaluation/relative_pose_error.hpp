// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include <topobag/error.hpp>
#include <topobag/evaluation/association.hpp>
#include <topobag/evaluation/pose_error.hpp>

namespace topobag {
inline namespace v0 {

/// Over which steps the relative pose error is taken.
struct RelativeStep {
  /// What a step's length is measured in.
  enum class Unit { frames, seconds, metres };
  Unit unit = Unit::frames;  ///< of `length`
  double length = 1.0;       ///< Δ: pairs of poses, s, or m along the true path; > 0
  double tolerance = 0.1;    ///< a step may differ from Δ by this share of it
  bool all_starts = true;    ///< every pose starts a step; else each where the last one ended
};

namespace detail {

/// Where each pair lies on the step's axis; non-decreasing.
template <typename Pairs>
std::vector<double> step_axis(const Pairs& pairs, RelativeStep::Unit unit) {
  std::vector<double> axis;
  axis.reserve(pairs.size());
  double path_m = 0.0;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (i > 0) {
      path_m += (pairs[i].T_true.translation() - pairs[i - 1].T_true.translation()).norm();
    }
    axis.push_back(unit == RelativeStep::Unit::frames    ? static_cast<double>(i)
                   : unit == RelativeStep::Unit::seconds ? pairs[i].stamp
                                                         : path_m);
  }
  return axis;
}

}  // namespace detail

/// Relative pose error (Sturm et al., IROS 2012): the size of E_i = (Q_i⁻¹ Q_j)⁻¹ (P_i⁻¹ P_j) with
/// Q true, P estimated and j the pose whose distance from i is nearest to Δ, the earlier of two;
/// a pose without such a j within the tolerance starts no step. Needs no alignment, but its scale
/// counts. Throws InvalidValue for a step that is not finite and positive. O(n log n).
/// @param pairs  a vector of `PosePair`
template <typename Pairs = std::vector<PosePair>>
std::vector<PoseError> relative_pose_errors(const Pairs& pairs, const RelativeStep& step = {}) {
  if (!(std::isfinite(step.length) && step.length > 0.0 && step.tolerance >= 0.0)) {
    throw InvalidValue("a relative step needs a finite length > 0 and a tolerance >= 0");
  }
  const std::vector<double> axis = detail::step_axis(pairs, step.unit);
  std::vector<PoseError> errors;
  for (std::size_t i = 0; i + 1 < pairs.size();) {
    const double goal = axis[i] + step.length;
    const auto first = axis.begin() + static_cast<std::ptrdiff_t>(i) + 1;
    auto end = std::lower_bound(first, axis.end(), goal);
    if (end == axis.end() || (end != first && goal - *(end - 1) <= *end - goal)) --end;
    const auto j = static_cast<std::size_t>(end - axis.begin());
    if (j > i && std::abs(axis[j] - goal) <= step.tolerance * step.length) {
      const Eigen::Isometry3d true_step = pairs[i].T_true.inverse() * pairs[j].T_true;
      const Eigen::Isometry3d estimated_step = pairs[i].T_estimate.inverse() * pairs[j].T_estimate;
      errors.push_back(pose_error(true_step, estimated_step));
      i = step.all_starts ? i + 1 : j;
    } else {
      ++i;
    }
  }
  return errors;
}

}  // namespace v0
}  // namespace topobag
