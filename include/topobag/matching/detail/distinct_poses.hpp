// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include <topobag/matching/match_options.hpp>
#include <topobag/matching/relative_pose.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// Whether two poses are the same one, as far as the options tell poses apart.
template <typename Pose>
bool same_pose(const Pose& a, const Pose& b, const MatchOptions& options) {
  const Eigen::Isometry3d between = a.T_candidate_query.inverse() * b.T_candidate_query;
  return between.translation().norm() <= options.distinct_translation &&
         Eigen::AngleAxisd(between.linear()).angle() <= options.distinct_rotation;
}

/// The poses by falling score, ties in their order, without those that need not be told beside a
/// better one: they are the same, and the better one is no less determined. O(n²).
template <typename Pose>
std::vector<Pose> distinct_poses(std::vector<Pose> poses, const MatchOptions& options) {
  // Positions are sorted, not poses: stable_sort's buffer is not aligned for AVX's matrices.
  std::vector<std::size_t> best_first(poses.size());
  std::iota(best_first.begin(), best_first.end(), std::size_t{0});
  std::stable_sort(best_first.begin(), best_first.end(), [&](std::size_t a, std::size_t b) {
    return poses[a].score() > poses[b].score();
  });
  std::vector<Pose> distinct;
  for (const std::size_t i : best_first) {
    const bool told = std::any_of(distinct.begin(), distinct.end(), [&](const Pose& better) {
      return (poses[i].degenerate || !better.degenerate) && same_pose(better, poses[i], options);
    });
    if (!told) distinct.push_back(std::move(poses[i]));
  }
  return distinct;
}

}  // namespace detail
}  // namespace v0
}  // namespace topobag
