// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include <topobag/graph/topology_graph.hpp>
#include <topobag/matching/detail/offered_pairs.hpp>
#include <topobag/matching/detail/pose_judge.hpp>
#include <topobag/matching/match_options.hpp>
#include <topobag/matching/point_pair.hpp>
#include <topobag/matching/relative_pose.hpp>

namespace topobag {
inline namespace v0 {

/// What two graphs say of a pose between them that is known but for a refinement: as `match_graphs`
/// says of the poses that it finds.
///
/// Nothing when fewer than three objects (two, where the vertical is known) agree with the pose. No
/// pair is left out, however many are offered. O(n · k + missing objects).
template <typename Scalar>
std::optional<RelativePose> judge_pose(const TopologyGraph<Scalar>& candidate,
                                       const TopologyGraph<Scalar>& query,
                                       const Eigen::Isometry3d& T_candidate_query,
                                       const MatchOptions& options = {}) {
  const std::vector<Correspondence> pairs =
      detail::offered_pairs(candidate, query, options.consistency);
  std::vector<PointPair> points;
  points.reserve(pairs.size());
  for (const Correspondence& pair : pairs) {
    points.push_back(point_pair(candidate.node(pair.candidate), query.node(pair.query),
                                options.consistency.noise));
  }
  const detail::PoseJudge<Scalar> judge(candidate, query, pairs, points, options);
  auto supporters = judge.supporters_of(T_candidate_query);
  if (supporters.size() < judge.min_pairs()) return std::nullopt;
  const auto settled = judge.settle(T_candidate_query, std::move(supporters));
  if (!settled) return std::nullopt;
  return judge.weigh(*settled);
}

}  // namespace v0
}  // namespace topobag
