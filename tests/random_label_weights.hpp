// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <random>
#include <utility>
#include <vector>

#include <topobag/graph/topology_graph.hpp>
#include <topobag/types/label_weights.hpp>

/// Two classes or more, `label` the best; the others' numbers are up to `apart` above it.
inline topobag::LabelWeights random_label_weights(std::mt19937& random, topobag::ClassId label,
                                                  int apart = 9) {
  std::uniform_real_distribution<double> unit(0.05, 1.0);
  std::vector<topobag::WeightedLabel> labels{
      {label, 0.1}};  // and more than all others together, below
  for (std::size_t more = 1 + random() % 7; more > 0; --more) {
    const int other = value(label) + 1 + static_cast<int>(random() % static_cast<unsigned>(apart));
    labels.push_back({topobag::ClassId{other}, unit(random)});
  }
  for (std::size_t i = 1; i < labels.size(); ++i) labels.front().weight += labels[i].weight;
  return topobag::LabelWeights(labels);
}

/// The same graph, two thirds of whose nodes, the first one among them, may be of several classes.
inline topobag::TopologyGraph<> with_label_weights(std::mt19937& random,
                                                   const topobag::TopologyGraph<>& graph) {
  std::vector<topobag::SemanticNode<>> nodes = graph.nodes();
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (i == 0 || random() % 3 != 0) {
      nodes[i].label_weights = random_label_weights(random, nodes[i].label);
    }
  }
  return topobag::TopologyGraph<>(std::move(nodes), graph.edges(), graph.views(), graph.gravity());
}
