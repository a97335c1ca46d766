// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include <topobag/graph/detail/rescaled.hpp>
#include <topobag/graph/topology_graph.hpp>
#include <topobag/matching/correspondence.hpp>
#include <topobag/matching/detail/one_to_one.hpp>
#include <topobag/matching/point_pair.hpp>
#include <topobag/matching/relative_pose.hpp>
#include <topobag/sensing/sensor_profile.hpp>
#include <topobag/types/semantic_node.hpp>

namespace topobag {
inline namespace v0 {

/// When two objects are at one place.
struct CoincidenceOptions {
  /// Standard deviations (of a 3-D residual) between them at most.
  double deviations = default_sensor.gate_deviations;
  double max_distance = default_sensor.gate;  ///< m
  NodeNoise noise = default_sensor.noise;     ///< of a node without a covariance
};

/// One-to-one pairs of objects that a pose brings together, whatever their classes: the pose's
/// inliers, then of the others the closest (in standard deviations) first, ties by index. Ascending
/// query node. O(n · k log(n · k)).
template <typename Scalar>
std::vector<Correspondence> coincident_objects(const TopologyGraph<Scalar>& candidate,
                                               const TopologyGraph<Scalar>& query,
                                               const RelativePose& pose,
                                               const CoincidenceOptions& options = {}) {
  const detail::Rescaled<TopologyGraph<Scalar>> in_metres(query, pose.scale);
  const std::vector<SemanticNode<Scalar>>& here = (*in_metres).nodes();
  std::vector<std::pair<double, Correspondence>> near;
  for (std::size_t q = 0; q < query.size(); ++q) {
    if (!here[q].position) continue;
    for (std::size_t p = 0; p < candidate.size(); ++p) {
      if (!candidate.nodes()[p].position) continue;
      const PointPair points = point_pair(candidate.nodes()[p], here[q], options.noise);
      if (points.residual(pose.T_candidate_query).norm() > options.max_distance) continue;
      const double deviation2 = points.squared_deviation(pose.T_candidate_query);
      if (deviation2 <= options.deviations * options.deviations) {
        near.push_back({deviation2, {node_index(p), node_index(q)}});
      }
    }
  }
  std::sort(near.begin(), near.end());
  std::vector<Correspondence> pairs = pose.inliers;
  detail::OneToOne unpaired(candidate.size(), query.size());
  for (const Correspondence& pair : pairs) unpaired.take(pair);
  for (const auto& [deviation2, pair] : near) {
    if (unpaired.take(pair)) pairs.push_back(pair);
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace v0
}  // namespace topobag
