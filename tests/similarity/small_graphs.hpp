// SPDX-License-Identifier: MIT
#pragma once

#include <initializer_list>
#include <utility>
#include <vector>

#include <topobag/graph/topology_graph.hpp>

/// A node of a class at (x, y, 0), m.
inline topobag::SemanticNode<> node_at(int label, double x = 0.0, double y = 0.0) {
  topobag::SemanticNode<> node;
  node.label = topobag::ClassId{label};
  node.position = Eigen::Vector3d(x, y, 0.0);
  return node;
}

inline topobag::TopologyGraph<> graph_of(
    std::vector<topobag::SemanticNode<>> nodes,
    std::initializer_list<std::pair<std::size_t, std::size_t>> edges = {}) {
  topobag::EdgeList list;
  for (const auto& [i, j] : edges) {
    list.push_back(topobag::make_edge(topobag::node_index(i), topobag::node_index(j)));
  }
  return topobag::TopologyGraph<>(std::move(nodes), std::move(list));
}
