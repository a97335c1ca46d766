// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <utility>
#include <vector>

#include <topobag/graph/scaled_graph.hpp>
#include <topobag/graph/topology_graph.hpp>
#include <topobag/matching/consistency_graph.hpp>
#include <topobag/matching/detail/distinct_poses.hpp>
#include <topobag/matching/detail/likely_scales.hpp>
#include <topobag/matching/detail/pose_search.hpp>
#include <topobag/matching/detail/pose_up_to_scale.hpp>
#include <topobag/matching/match_options.hpp>
#include <topobag/matching/relative_pose.hpp>

namespace topobag {
inline namespace v0 {

/// Every distinct pose under which the query graph fits the candidate graph, and chance does not
/// explain it much better; the best one where it does.
struct GraphMatch {
  /// By falling score; empty when fewer agree than determine a pose: three, or two where both
  /// graphs know which way is down; one more where the scale is not known.
  std::vector<RelativePose> poses;
  bool complete = true;  ///< false when a budget ended first
};

namespace detail {

/// `match_graphs` of graphs that are in one unit.
template <typename Scalar>
GraphMatch match_in_one_unit(const TopologyGraph<Scalar>& candidate,
                             const KnownDistances<Scalar>& query, const MatchOptions& options) {
  GraphMatch match;
  match.poses = PoseSearch<Scalar>(candidate, query, options).run(match.complete);
  return match;
}

/// `match_graphs` where the query's unit is not known: at each likely scale, and what is found
/// there refined with it.
template <typename Scalar>
GraphMatch match_up_to_scale(const TopologyGraph<Scalar>& candidate,
                             const KnownDistances<Scalar>& query, const MatchOptions& options,
                             const ScaleRange& range) {
  const ScaleJudge<Scalar> judge(candidate, query.graph(), options, range);
  // At a scale that is a little off a true pose, too, may fit worse than chance does.
  MatchOptions every_pose = options;
  every_pose.min_promise = std::numeric_limits<double>::lowest();
  GraphMatch match;
  std::vector<RelativePose> poses;
  for (const double scale : likely_scales(candidate, query, options.consistency, range)) {
    const TopologyGraph<Scalar> here = scaled(query.graph(), scale);
    const GraphMatch at_scale = match_in_one_unit(
        candidate, KnownDistances<Scalar>(here, options.consistency.noise), every_pose);
    match.complete = match.complete && at_scale.complete;
    for (const RelativePose& pose : at_scale.poses) {
      if (pose.inliers.size() + 1 < judge.min_pairs()) continue;
      if (auto settled = judge.settle(pose.T_candidate_query, scale)) {
        poses.push_back(std::move(*settled));
      }
    }
  }
  match.poses = distinct_poses(std::move(poses), options);
  return match;
}

/// `match_graphs` for a query that is matched with many.
template <typename Scalar>
GraphMatch match_known(const TopologyGraph<Scalar>& candidate, const KnownDistances<Scalar>& query,
                       const MatchOptions& options) {
  if (options.scale) return match_up_to_scale(candidate, query, options, *options.scale);
  return match_in_one_unit(candidate, query, options);
}

}  // namespace detail

/// Matches two graphs and works out every distinct pose between them, best first.
///
/// Large sets of consistent pairs (`match_nodes`) propose poses, each of which gathers the pairs
/// that it brings together. What chance does not explain much better is refined over them, and
/// weighed against chance and against what should have been seen; where it explains all better, the
/// best one is. Mirror images fall out in the rigid fit. Deterministic. Cost: that of `match_nodes`
/// and a few microseconds a hypothesis.
///
/// Where the query's unit is not known (`MatchOptions::scale`), the ratios of the distances between
/// pairs of objects propose a few scales; at each the query is matched as if it were known, and
/// scale and pose are refined in turn. Some ten times the cost.
template <typename Scalar>
GraphMatch match_graphs(const TopologyGraph<Scalar>& candidate, const TopologyGraph<Scalar>& query,
                        const MatchOptions& options = {}) {
  return detail::match_known(
      candidate, detail::KnownDistances<Scalar>(query, options.consistency.noise), options);
}

#ifdef TOPOBAG_COMPILED  // these are in the library topobag::compiled
extern template GraphMatch detail::match_known(const TopologyGraph<double>&,
                                               const detail::KnownDistances<double>&,
                                               const MatchOptions&);
extern template GraphMatch detail::match_in_one_unit(const TopologyGraph<double>&,
                                                     const detail::KnownDistances<double>&,
                                                     const MatchOptions&);
extern template GraphMatch match_graphs(const TopologyGraph<double>&, const TopologyGraph<double>&,
                                        const MatchOptions&);
#endif

}  // namespace v0
}  // namespace topobag
