// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include <topobag/similarity/detail/assignment.hpp>
#include <topobag/types/ids.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// The largest Σ gain(i, j) over one-to-one pairs of items of equal labels.
/// Preconditions: both label lists ascend; gains are finite. O(Σ r²c) over the classes.
template <typename Gain>
double assigned_gain(const std::vector<ClassId>& p, const std::vector<ClassId>& q,
                     const Gain& gain) {
  double sum = 0.0;
  for (auto p_begin = p.begin(); p_begin != p.end();) {
    const auto p_end = std::upper_bound(p_begin, p.end(), *p_begin);
    const auto [q_begin, q_end] = std::equal_range(q.begin(), q.end(), *p_begin);
    Eigen::MatrixXd gains(p_end - p_begin, q_end - q_begin);
    const auto first_p = static_cast<std::size_t>(p_begin - p.begin());
    const auto first_q = static_cast<std::size_t>(q_begin - q.begin());
    for (Eigen::Index i = 0; i < gains.rows(); ++i) {
      for (Eigen::Index j = 0; j < gains.cols(); ++j) {
        gains(i, j) =
            gain(first_p + static_cast<std::size_t>(i), first_q + static_cast<std::size_t>(j));
      }
    }
    const auto column_of = best_assignment(gains);
    for (std::size_t i = 0; i < column_of.size(); ++i) {
      if (!column_of[i]) continue;
      sum += gains(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(*column_of[i]));
    }
    p_begin = p_end;
  }
  return sum;
}

}  // namespace detail
}  // namespace v0
}  // namespace topobag
