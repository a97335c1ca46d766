// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <tuple>
#include <utility>
#include <vector>

#include <topobag/graph/scaled_graph.hpp>
#include <topobag/graph/topology_graph.hpp>
#include <topobag/matching/consistency_graph.hpp>
#include <topobag/matching/detail/clique_search.hpp>
#include <topobag/matching/detail/distinct_poses.hpp>
#include <topobag/matching/detail/likely_scales.hpp>
#include <topobag/matching/detail/pose_judge.hpp>
#include <topobag/matching/detail/pose_up_to_scale.hpp>
#include <topobag/matching/match_nodes.hpp>
#include <topobag/matching/match_options.hpp>
#include <topobag/matching/relative_pose.hpp>

namespace topobag {
inline namespace v0 {

/// Every distinct pose under which the query graph fits the candidate graph.
struct GraphMatch {
  /// By falling score; empty when fewer agree than determine a pose: three, or two where both
  /// graphs know which way is down; one more where the scale is not known.
  std::vector<RelativePose> poses;
  bool complete = true;  ///< false when a budget ended first
};

namespace detail {

/// Works out poses for one candidate and one query graph.
template <typename Scalar>
class PoseSearch {
 public:
  PoseSearch(const TopologyGraph<Scalar>& candidate, const KnownDistances<Scalar>& query,
             const MatchOptions& options)
      : options_(options),
        graph_(candidate, query, options.consistency),
        judge_(candidate, query.graph(), graph_.pairs(), graph_.points(), options) {}
  PoseSearch(const PoseSearch&) = delete;
  PoseSearch& operator=(const PoseSearch&) = delete;

  GraphMatch run() const {
    GraphMatch match;
    CliqueSearch search(graph_.agreement(), graph_.query_of());
    std::vector<std::pair<double, std::vector<std::size_t>>> hypotheses;  // rms difference, clique
    std::size_t largest = 0;
    const std::size_t steps =
        search.run(judge_.min_pairs(), options_.slack, options_.max_steps,
                   [&](const std::vector<std::size_t>& clique) {
                     largest = std::max(largest, clique.size());
                     hypotheses.emplace_back(rms_distance_difference(graph_, clique), clique);
                   });
    match.complete = graph_.complete() && steps < options_.max_steps;
    std::sort(hypotheses.begin(), hypotheses.end(), [](const auto& a, const auto& b) {
      return std::make_tuple(b.second.size(), a.first, std::cref(a.second)) <
             std::make_tuple(a.second.size(), b.first, std::cref(b.second));
    });
    // Those that are large enough come first.
    const auto worth =
        std::partition_point(hypotheses.begin(), hypotheses.end(), [&](const auto& hypothesis) {
          return hypothesis.second.size() + options_.slack >= largest;
        });
    hypotheses.erase(worth, hypotheses.end());
    if (hypotheses.size() > options_.max_hypotheses) {
      hypotheses.resize(options_.max_hypotheses);
      match.complete = false;
    }

    std::vector<typename PoseJudge<Scalar>::Settled> settled;
    for (const auto& [rms, clique] : hypotheses) {
      if (auto pose = judge_.settle(judge_.fitted(clique), clique, settled))
        settled.push_back(std::move(*pose));
    }
    std::vector<RelativePose> poses;
    poses.reserve(settled.size());
    for (const auto& pose : settled) poses.push_back(judge_.weigh(pose));
    match.poses = distinct_poses(std::move(poses), options_);
    return match;
  }

 private:
  const MatchOptions& options_;
  ConsistencyGraph graph_;
  PoseJudge<Scalar> judge_;  ///< refers to `graph_`
};

/// `match_graphs` of graphs that are in one unit.
template <typename Scalar>
GraphMatch match_in_one_unit(const TopologyGraph<Scalar>& candidate,
                             const KnownDistances<Scalar>& query, const MatchOptions& options) {
  return PoseSearch<Scalar>(candidate, query, options).run();
}

/// `match_graphs` where the query's unit is not known: at each likely scale, and what is found
/// there refined with it.
template <typename Scalar>
GraphMatch match_up_to_scale(const TopologyGraph<Scalar>& candidate,
                             const KnownDistances<Scalar>& query, const MatchOptions& options,
                             const ScaleRange& range) {
  const ScaleJudge<Scalar> judge(candidate, query.graph(), options, range);
  GraphMatch match;
  std::vector<RelativePose> poses;
  for (const double scale : likely_scales(candidate, query, options.consistency, range)) {
    const TopologyGraph<Scalar> here = scaled(query.graph(), scale);
    const GraphMatch at_scale = match_in_one_unit(
        candidate, KnownDistances<Scalar>(here, options.consistency.noise), options);
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
/// Large sets of consistent pairs (`match_nodes`) propose poses; each gathers the pairs that it
/// brings together, is refined over them, and is weighed against chance and against what should
/// have been seen. Mirror images fall out in the rigid fit. Deterministic. Cost: that of
/// `match_nodes` and a few microseconds a hypothesis.
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
