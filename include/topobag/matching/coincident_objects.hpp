// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include <topobag/graph/topology_graph.hpp>
#include <topobag/matching/correspondence.hpp>
#include <topobag/matching/refine_pose.hpp>
#include <topobag/matching/relative_pose.hpp>
#include <topobag/sensing/node_noise.hpp>

namespace topobag {
inline namespace v0 {

/// When two objects are at one place.
struct CoincidenceOptions {
  double deviations = 3.0;    ///< standard deviations (of a 3-D residual) between them at most
  double max_distance = 0.4;  ///< m
};

/// One-to-one pairs of objects that a pose brings together, whatever their classes: the pose's
/// inliers, then of the others the closest (in standard deviations) first, ties by index. Ascending
/// query node. O(n · k log(n · k)).
template <typename Scalar>
std::vector<Correspondence> coincident_objects(const TopologyGraph<Scalar>& candidate,
                                               const TopologyGraph<Scalar>& query,
                                               const RelativePose& pose,
                                               const CoincidenceOptions& options = {}) {
  std::vector<Correspondence> pairs = pose.inliers;
  std::vector<bool> candidate_taken(candidate.size(), false), query_taken(query.size(), false);
  for (const Correspondence& pair : pairs) {
    candidate_taken[value(pair.candidate)] = query_taken[value(pair.query)] = true;
  }
  std::vector<std::pair<double, Correspondence>> near;
  for (std::size_t q = 0; q < query.size(); ++q) {
    if (query_taken[q] || !query.nodes()[q].position) continue;
    for (std::size_t p = 0; p < candidate.size(); ++p) {
      if (candidate_taken[p] || !candidate.nodes()[p].position) continue;
      const auto& there = candidate.nodes()[p];
      const auto& here = query.nodes()[q];
      const PointPair points{there.position->template cast<double>(),
                             here.position->template cast<double>(), position_covariance(there),
                             position_covariance(here)};
      if (points.residual(pose.T_candidate_query).norm() > options.max_distance) continue;
      const double deviation2 = points.squared_deviation(pose.T_candidate_query);
      if (deviation2 <= options.deviations * options.deviations) {
        near.push_back({deviation2, {node_index(p), node_index(q)}});
      }
    }
  }
  std::sort(near.begin(), near.end());
  for (const auto& [deviation2, pair] : near) {
    if (candidate_taken[value(pair.candidate)] || query_taken[value(pair.query)]) continue;
    candidate_taken[value(pair.candidate)] = query_taken[value(pair.query)] = true;
    pairs.push_back(pair);
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace v0
}  // namespace topobag
