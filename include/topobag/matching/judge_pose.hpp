// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include <Eigen/Geometry>

#include <topobag/graph/topology_graph.hpp>
#include <topobag/matching/detail/pose_up_to_scale.hpp>
#include <topobag/matching/match_options.hpp>
#include <topobag/matching/relative_pose.hpp>

namespace topobag {
inline namespace v0 {

/// What two graphs say of a pose between them that is known but for a refinement: as `match_graphs`
/// says of the poses that it finds.
///
/// Nothing when fewer than three objects (two, where the vertical is known) agree with the pose; of
/// unknown scale (`MatchOptions::scale`) it takes one more, and the scale is refined as well. No
/// pair is left out, however many are offered. O(n · k + missing objects).
/// @param scale  candidate's metres in a unit of the query, about; read where it is unknown
template <typename Scalar>
std::optional<RelativePose> judge_pose(const TopologyGraph<Scalar>& candidate,
                                       const TopologyGraph<Scalar>& query,
                                       const Eigen::Isometry3d& T_candidate_query,
                                       const MatchOptions& options = {}, double scale = 1.0) {
  if (!options.scale) {
    return detail::judge_in_one_unit(candidate, query, T_candidate_query, options);
  }
  const detail::ScaleJudge<Scalar> judge(candidate, query, options, *options.scale);
  return judge.settle(T_candidate_query, scale);
}

#ifdef TOPOBAG_COMPILED  // in the library topobag::compiled
extern template std::optional<RelativePose> judge_pose(const TopologyGraph<double>&,
                                                       const TopologyGraph<double>&,
                                                       const Eigen::Isometry3d&,
                                                       const MatchOptions&, double);
#endif

}  // namespace v0
}  // namespace topobag
