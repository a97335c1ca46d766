// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <topobag/graph/correlation_matrix.hpp>
#include <topobag/graph/topology_graph.hpp>
#include <topobag/graph/vertex_matrix.hpp>

namespace topobag {
inline namespace v0 {

/// W = D · O of eq. 9 and 10: n × 4. Permuting the nodes permutes its rows. O(n²).
template <typename Scalar>
Eigen::Matrix<Scalar, Eigen::Dynamic, 4> topology_weight(const TopologyGraph<Scalar>& graph,
                                                         Scalar depth_scale = Scalar(1)) {
  return correlation_matrix(graph) * vertex_matrix(graph, depth_scale);
}

/// The same W from the sparse D. O(n + m).
template <typename Scalar>
Eigen::Matrix<Scalar, Eigen::Dynamic, 4> sparse_topology_weight(const TopologyGraph<Scalar>& graph,
                                                                Scalar depth_scale = Scalar(1)) {
  return sparse_correlation_matrix(graph) * vertex_matrix(graph, depth_scale);
}

}  // namespace v0
}  // namespace topobag
