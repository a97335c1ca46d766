// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <topobag/graph/topology_graph.hpp>

namespace topobag {
inline namespace v0 {

/// D of eq. 6 and 8: n × n, symmetric, 1 on the diagonal, d_ij (m, eq. 4) where i and j share an
/// edge, else 0. O(n² + m).
template <typename Scalar>
Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic> correlation_matrix(
    const TopologyGraph<Scalar>& graph) {
  const auto n = static_cast<Eigen::Index>(graph.size());
  Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic> D;
  D.setIdentity(n, n);
  for (std::size_t e = 0; e < graph.edges().size(); ++e) {
    const auto i = static_cast<Eigen::Index>(value(graph.edges()[e].a));
    const auto j = static_cast<Eigen::Index>(value(graph.edges()[e].b));
    D(i, j) = D(j, i) = graph.lengths()[e];
  }
  return D;
}

/// The same D with only its diagonal and edges stored. O(n + m).
template <typename Scalar>
Eigen::SparseMatrix<Scalar> sparse_correlation_matrix(const TopologyGraph<Scalar>& graph) {
  const auto n = static_cast<Eigen::Index>(graph.size());
  std::vector<Eigen::Triplet<Scalar>> entries;
  entries.reserve(graph.size() + 2 * graph.edges().size());
  for (int i = 0; i < static_cast<int>(n); ++i) entries.emplace_back(i, i, Scalar(1));
  for (std::size_t e = 0; e < graph.edges().size(); ++e) {
    const int i = static_cast<int>(value(graph.edges()[e].a));
    const int j = static_cast<int>(value(graph.edges()[e].b));
    entries.emplace_back(i, j, graph.lengths()[e]);
    entries.emplace_back(j, i, graph.lengths()[e]);
  }
  Eigen::SparseMatrix<Scalar> D(n, n);
  D.setFromTriplets(entries.begin(), entries.end());
  return D;
}

}  // namespace v0
}  // namespace topobag
