// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

#include <topobag/edges/knn_edges.hpp>
#include <topobag/graph/topology_graph.hpp>

/// Nodes of classes 1 to `classes` strewn through a room before a 640 × 480 camera; with
/// `all_placed = false` one in five has no pixel, one in five no position.
inline std::vector<topobag::SemanticNode<>> random_nodes(std::mt19937& random, std::size_t count,
                                                         int classes = 4, bool all_placed = true) {
  std::uniform_real_distribution<double> metres(-2.0, 2.0), unit(0.0, 1.0);
  std::uniform_int_distribution<int> label(1, classes);
  std::vector<topobag::SemanticNode<>> nodes(count);
  for (auto& node : nodes) {
    node.label = topobag::ClassId{label(random)};
    node.size = {0.1 + unit(random), 0.1 + unit(random)};
    if (all_placed || unit(random) > 0.2) {
      node.pixel = Eigen::Vector2d(640.0 * unit(random), 480.0 * unit(random));
    }
    if (all_placed || unit(random) > 0.2) {
      node.position = Eigen::Vector3d(metres(random), metres(random), 3.0 + metres(random));
      node.z = node.position->z();
    }
  }
  return nodes;
}

inline topobag::TopologyGraph<> random_graph(std::mt19937& random, std::size_t count,
                                             int classes = 4, bool all_placed = true) {
  return topobag::make_topology_graph(random_nodes(random, count, classes, all_placed),
                                      topobag::KnnEdges{3});
}

/// A random order of `count` things.
inline std::vector<std::size_t> random_order(std::mt19937& random, std::size_t count) {
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::shuffle(order.begin(), order.end(), random);
  return order;
}

/// The same graph with node i in place order[i], edges carried along.
inline topobag::TopologyGraph<> permuted(const topobag::TopologyGraph<>& graph,
                                         const std::vector<std::size_t>& order) {
  std::vector<topobag::SemanticNode<>> nodes(graph.size());
  for (std::size_t i = 0; i < graph.size(); ++i) nodes[order[i]] = graph.nodes()[i];
  topobag::EdgeList edges;
  for (const topobag::Edge& edge : graph.edges()) {
    edges.push_back(topobag::make_edge(topobag::node_index(order[value(edge.a)]),
                                       topobag::node_index(order[value(edge.b)])));
  }
  return topobag::TopologyGraph<>(std::move(nodes), std::move(edges));
}
