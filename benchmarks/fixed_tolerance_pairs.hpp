// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include <topobag/graph/topology_graph.hpp>

/// A node of the candidate and one of the query that may be one object.
struct PlainPair {
  std::size_t candidate = 0, query = 0;
};

/// Pairs of placed nodes of one class, whatever their sizes.
inline std::vector<PlainPair> same_class_pairs(const topobag::TopologyGraph<>& candidate,
                                               const topobag::TopologyGraph<>& query) {
  std::vector<PlainPair> pairs;
  for (std::size_t q = 0; q < query.size(); ++q) {
    for (std::size_t p = 0; p < candidate.size(); ++p) {
      const auto &of_candidate = candidate.nodes()[p], &of_query = query.nodes()[q];
      const bool placed = of_candidate.position && of_query.position;
      if (placed && of_candidate.label == of_query.label) pairs.push_back({p, q});
    }
  }
  return pairs;
}

/// How well each two pairs keep their distance: exp(−Δ² / 2σ²) of the difference Δ of the two
/// distances, 1 for a pair with itself, 0 beyond the tolerance or for a node in two pairs. With a
/// noise that is one for all, as estimators have it that know nothing of a sensor.
/// @param tolerance  m; σ is a third of it
inline Eigen::MatrixXd pair_affinity(const topobag::TopologyGraph<>& candidate,
                                     const topobag::TopologyGraph<>& query,
                                     const std::vector<PlainPair>& pairs, double tolerance) {
  const auto count = static_cast<Eigen::Index>(pairs.size());
  Eigen::MatrixXd affinity = Eigen::MatrixXd::Identity(count, count);
  const auto apart = [](const topobag::TopologyGraph<>& graph, std::size_t a, std::size_t b) {
    return (*graph.nodes()[a].position - *graph.nodes()[b].position).norm();
  };
  for (Eigen::Index i = 0; i < count; ++i) {
    const PlainPair& a = pairs[static_cast<std::size_t>(i)];
    for (Eigen::Index j = 0; j < i; ++j) {
      const PlainPair& b = pairs[static_cast<std::size_t>(j)];
      if (a.candidate == b.candidate || a.query == b.query) continue;
      const double difference =
          apart(candidate, a.candidate, b.candidate) - apart(query, a.query, b.query);
      if (std::abs(difference) > tolerance) continue;
      const double deviations = 3.0 * difference / tolerance;
      affinity(i, j) = affinity(j, i) = std::exp(-0.5 * deviations * deviations);
    }
  }
  return affinity;
}
