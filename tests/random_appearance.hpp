// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <random>
#include <utility>
#include <vector>

#include <topobag/graph/topology_graph.hpp>
#include <topobag/types/appearance.hpp>

/// A random direction.
inline topobag::Appearance random_appearance(std::mt19937& random, topobag::AppearanceKind kind) {
  std::normal_distribution<double> normal;
  Eigen::VectorXd vector(static_cast<Eigen::Index>(kind.length()));
  for (Eigen::Index i = 0; i < vector.size(); ++i) vector(i) = normal(random);
  return topobag::Appearance(kind, vector);
}

/// The same graph, two thirds of whose nodes, the first one among them, look like something.
inline topobag::TopologyGraph<> with_appearance(std::mt19937& random,
                                                const topobag::TopologyGraph<>& graph,
                                                topobag::AppearanceKind kind) {
  std::vector<topobag::SemanticNode<>> nodes = graph.nodes();
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (i == 0 || random() % 3 != 0) nodes[i].appearance = random_appearance(random, kind);
  }
  return topobag::TopologyGraph<>(std::move(nodes), graph.edges(), graph.views(), graph.gravity());
}
