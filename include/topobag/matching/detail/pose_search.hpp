// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <tuple>
#include <utility>
#include <vector>

#include <topobag/graph/topology_graph.hpp>
#include <topobag/matching/consistency_graph.hpp>
#include <topobag/matching/detail/clique_search.hpp>
#include <topobag/matching/detail/distinct_poses.hpp>
#include <topobag/matching/detail/pose_judge.hpp>
#include <topobag/matching/match_nodes.hpp>
#include <topobag/matching/match_options.hpp>
#include <topobag/matching/relative_pose.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// Works out poses for one candidate and one query graph.
template <typename Scalar>
class PoseSearch {
  using Clique = std::vector<std::size_t>;
  using Proposal = typename PoseJudge<Scalar>::Proposal;
  using Settled = typename PoseJudge<Scalar>::Settled;

 public:
  PoseSearch(const TopologyGraph<Scalar>& candidate, const KnownDistances<Scalar>& query,
             const MatchOptions& options)
      : options_(options),
        graph_(candidate, query, options.consistency),
        judge_(candidate, query.graph(), graph_.pairs(), graph_.points(), options) {}
  PoseSearch(const PoseSearch&) = delete;
  PoseSearch& operator=(const PoseSearch&) = delete;

  /// Distinct poses, best first.
  /// @param complete  false afterwards when a budget ended first
  std::vector<RelativePose> run(bool& complete) const {
    std::vector<Settled> settled;
    for (Proposal& proposal : best_first(large_cliques(complete))) {
      if (proposal.significance < options_.min_promise && !settled.empty()) break;
      if (auto pose =
              judge_.settle(proposal.T_candidate_query, std::move(proposal.pairs), settled)) {
        settled.push_back(std::move(*pose));
      }
    }
    std::vector<RelativePose> poses;
    poses.reserve(settled.size());
    for (const Settled& pose : settled) poses.push_back(judge_.weigh(pose));
    return distinct_poses(std::move(poses), options_);
  }

 private:
  /// Those that are tried: the largest first, of equally large ones the tightest.
  std::vector<Clique> large_cliques(bool& complete) const {
    std::vector<Clique> cliques;
    std::size_t largest = 0;
    CliqueSearch search(graph_.agreement(), graph_.query_of());
    const std::size_t steps =
        search.run(judge_.min_pairs(), options_.slack, options_.max_steps, [&](Clique clique) {
          largest = std::max(largest, clique.size());
          cliques.push_back(std::move(clique));
        });
    complete = graph_.complete() && steps < options_.max_steps;

    std::vector<std::pair<double, Clique>> by_fit;  // rms difference, clique
    for (Clique& clique : cliques) {
      if (clique.size() + options_.slack < largest) continue;  // found before the largest
      const double rms = rms_distance_difference(graph_, clique);
      by_fit.emplace_back(rms, std::move(clique));
    }
    std::sort(by_fit.begin(), by_fit.end(), [](const auto& a, const auto& b) {
      return std::make_tuple(b.second.size(), a.first, std::cref(a.second)) <
             std::make_tuple(a.second.size(), b.first, std::cref(b.second));
    });
    if (by_fit.size() > options_.max_hypotheses) {
      by_fit.resize(options_.max_hypotheses);
      complete = false;
    }
    cliques.clear();
    for (auto& [rms, clique] : by_fit) cliques.push_back(std::move(clique));
    return cliques;
  }

  /// What they propose.
  std::vector<Proposal> best_first(const std::vector<Clique>& cliques) const {
    std::vector<Proposal> proposals;
    for (const Clique& clique : cliques) {
      if (auto proposal = judge_.propose(clique, proposals)) {
        proposals.push_back(std::move(*proposal));
      }
    }
    std::sort(proposals.begin(), proposals.end(), [](const Proposal& a, const Proposal& b) {
      if (a.significance != b.significance) return a.significance > b.significance;
      return a.pairs < b.pairs;
    });
    return proposals;
  }

  const MatchOptions& options_;
  ConsistencyGraph graph_;
  PoseJudge<Scalar> judge_;  ///< refers to `graph_`
};

}  // namespace detail
}  // namespace v0
}  // namespace topobag
