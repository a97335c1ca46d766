// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include <topobag/graph/topology_graph.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// The nodes that share an edge with each node, ascending. O(n + m).
template <typename Scalar>
std::vector<std::vector<std::size_t>> neighbors(const TopologyGraph<Scalar>& graph) {
  std::vector<std::vector<std::size_t>> lists(graph.size());
  for (const Edge& edge : graph.edges()) {
    lists[value(edge.a)].push_back(value(edge.b));
    lists[value(edge.b)].push_back(value(edge.a));
  }
  return lists;
}

}  // namespace detail
}  // namespace v0
}  // namespace topobag
