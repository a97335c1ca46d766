// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include <topobag/graph/topology_graph.hpp>
#include <topobag/matching/consistency_graph.hpp>
#include <topobag/matching/correspondence.hpp>
#include <topobag/matching/detail/clique_search.hpp>

namespace topobag {
inline namespace v0 {

/// How sets of agreeing nodes are searched.
struct MatchNodesOptions {
  ConsistencyOptions consistency{};  ///< which pairs of nodes agree
  std::size_t max_steps =
      20000;  ///< branches of the search after which the best so far is returned
};

/// A set of node pairs that all agree with each other.
struct NodeMatching {
  std::vector<Correspondence> pairs;  ///< ascending query node
  double rms_difference = 0.0;        ///< of the pairs' mutual distances, m; 0 for fewer than two
  bool complete = true;               ///< false when a budget ended first: a larger set may exist
  std::size_t steps = 0;              ///< branches searched
};

namespace detail {

/// Root mean square of d(p, p') − d(q, q') over all pairs of `clique`, m.
inline double rms_distance_difference(const ConsistencyGraph& graph,
                                      const std::vector<std::size_t>& clique) {
  if (clique.size() < 2) return 0.0;
  double sum = 0.0;
  for (std::size_t i = 0; i < clique.size(); ++i) {
    for (std::size_t j = i + 1; j < clique.size(); ++j) {
      const double difference = graph.difference(clique[i], clique[j]);
      sum += difference * difference;
    }
  }
  const auto n = static_cast<double>(clique.size());
  return std::sqrt(sum / (0.5 * n * (n - 1.0)));
}

inline std::vector<Correspondence> pairs_of(const ConsistencyGraph& graph,
                                            const std::vector<std::size_t>& clique) {
  std::vector<Correspondence> pairs;
  pairs.reserve(clique.size());
  for (const std::size_t v : clique) pairs.push_back(graph.pairs()[v]);
  return pairs;
}

}  // namespace detail

/// The largest set of class-compatible node pairs whose mutual distances agree; of equally large
/// sets the one whose distances differ least.
///
/// Found exactly, by branch and bound over the maximal cliques of the consistency graph, unless the
/// deterministic budget ends first. Distances alone cannot tell a layout from its mirror image: see
/// `match_graphs`. Its size and r.m.s. do not change under a permutation of the nodes or a rigid
/// motion of either graph; of sets equal in both, the order of the nodes decides. Exponential at
/// worst; microseconds for the graphs of real frames.
template <typename Scalar>
NodeMatching match_nodes(const TopologyGraph<Scalar>& candidate, const TopologyGraph<Scalar>& query,
                         const MatchNodesOptions& options = {}) {
  const ConsistencyGraph graph(candidate, query, options.consistency);
  detail::CliqueSearch search(graph.agreement(), graph.query_of());
  NodeMatching best;
  best.steps = search.run(1, 0, options.max_steps, [&](const std::vector<std::size_t>& clique) {
    const double rms = detail::rms_distance_difference(graph, clique);
    if (clique.size() > best.pairs.size() ||
        (clique.size() == best.pairs.size() && rms < best.rms_difference)) {
      best.pairs = detail::pairs_of(graph, clique);
      best.rms_difference = rms;
    }
  });
  best.complete = graph.complete() && best.steps < options.max_steps;
  return best;
}

}  // namespace v0
}  // namespace topobag
