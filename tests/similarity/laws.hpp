// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <random>
#include <utility>
#include <vector>

#include <topobag/edges/knn_edges.hpp>
#include <topobag/graph/topology_graph.hpp>
#include <topobag/similarity/similarity.hpp>
#include <topobag/similarity/sparse_histogram.hpp>

#include "catch.hpp"
#include "random_graphs.hpp"

/// What every similarity of the library promises; each is checked on random graphs.
namespace laws {

using Graph = topobag::TopologyGraph<double>;

/// Random graphs of all small sizes, some with unplaced nodes, some without edges.
inline std::vector<Graph> sample(unsigned seed) {
  std::mt19937 random(seed);
  std::vector<Graph> graphs;
  for (std::size_t n = 1; n <= 12; ++n) {
    graphs.push_back(random_graph(random, n));
    graphs.push_back(random_graph(random, n, 3, false));
    graphs.emplace_back(random_nodes(random, n, 2));
  }
  return graphs;
}

inline topobag::TopologyGraph<float> in_floats(const Graph& graph) {
  std::vector<topobag::SemanticNode<float>> nodes(graph.size());
  for (std::size_t i = 0; i < graph.size(); ++i) {
    const topobag::SemanticNode<>& node = graph.nodes()[i];
    nodes[i].label = node.label;
    if (node.pixel) nodes[i].pixel = node.pixel->cast<float>();
    if (node.position) nodes[i].position = node.position->cast<float>();
    nodes[i].z = static_cast<float>(node.z);
    nodes[i].size = node.size.cast<float>();
  }
  return topobag::TopologyGraph<float>(std::move(nodes), graph.edges());
}

/// In [0, 1], 1 for a graph and itself, symmetric, 0 for the empty graph; in two steps as in one.
template <typename Similarity>
void check_definition(const Similarity& similarity) {
  STATIC_REQUIRE(topobag::is_similarity_v<Similarity, Graph>);
  STATIC_REQUIRE(topobag::is_similarity_v<Similarity, topobag::TopologyGraph<float>>);
  STATIC_REQUIRE(topobag::has_descriptor_v<Similarity, Graph>);
  const std::vector<Graph> graphs = sample(1);
  for (const Graph& p : graphs) {
    CHECK(similarity(p, p) == Approx(1.0).epsilon(1e-12));
    CHECK(similarity(p, Graph{}) == 0.0);
    CHECK(similarity(Graph{}, p) == 0.0);
    for (const Graph& q : graphs) {
      const double s = similarity(p, q);
      CHECK(s >= 0.0);
      CHECK(s <= 1.0);
      CHECK(similarity(q, p) == s);
      CHECK(similarity.similarity(similarity.descriptor(p), similarity.descriptor(q)) == s);
      if constexpr (topobag::is_jaccard_v<Similarity>) {
        CHECK(topobag::jaccard(similarity.descriptor(p), similarity.descriptor(q)) == s);
      }
    }
  }
  CHECK(similarity(Graph{}, Graph{}) == 0.0);
}

/// The order of the nodes does not matter, but for rounding up to `tolerance`.
template <typename Similarity>
void check_node_order(const Similarity& similarity, double tolerance = 0.0) {
  std::mt19937 random(2);
  const std::vector<Graph> graphs = sample(3);
  for (const Graph& p : graphs) {
    const Graph shuffled = permuted(p, random_order(random, p.size()));
    for (const Graph& q : graphs) {
      CHECK(std::abs(similarity(shuffled, q) - similarity(p, q)) <= tolerance);
    }
  }
}

/// The camera's motion does not matter.
template <typename Similarity>
void check_motion(const Similarity& similarity) {
  const Eigen::Isometry3d T = Eigen::Translation3d(0.3, -1.0, 2.0) *
                              Eigen::AngleAxisd(0.8, Eigen::Vector3d(1.0, 2.0, -1.0).normalized());
  for (const Graph& p : sample(4)) {
    std::vector<topobag::SemanticNode<>> nodes = p.nodes();
    for (topobag::SemanticNode<>& node : nodes) {
      if (node.position) node.position = T * *node.position;
      node.pixel.reset();
    }
    CHECK(similarity(p, Graph(nodes, p.edges())) == Approx(1.0).epsilon(1e-9));
  }
}

/// Graphs without a class in common have nothing in common.
template <typename Similarity>
void check_foreign_classes(const Similarity& similarity) {
  std::mt19937 random(5);
  for (std::size_t n = 1; n < 10; ++n) {
    const Graph p = random_graph(random, n);
    std::vector<topobag::SemanticNode<>> nodes = p.nodes();
    for (auto& node : nodes) node.label = topobag::ClassId{value(node.label) + 100};
    CHECK(similarity(p, Graph(nodes, p.edges())) == 0.0);
  }
}

/// Graphs of floats are as similar as those of doubles.
template <typename Similarity>
void check_floats(const Similarity& similarity) {
  const std::vector<Graph> graphs = sample(7);
  for (std::size_t i = 1; i < graphs.size(); ++i) {
    const Graph &p = graphs[i - 1], &q = graphs[i];
    CHECK(std::abs(similarity(in_floats(p), in_floats(q)) - similarity(p, q)) < 1e-4);
  }
}

/// Coincident and far-off nodes give numbers.
template <typename Similarity>
void check_extremes(const Similarity& similarity) {
  std::mt19937 random(6);
  auto nodes = random_nodes(random, 6, 2);
  nodes[1] = nodes[0];
  nodes[2].position = Eigen::Vector3d(1e300, -1e300, 1e300);
  nodes[3].position = Eigen::Vector3d(-1e300, 1e300, 1e300);
  const Graph p = topobag::make_topology_graph(nodes, topobag::KnnEdges{3});
  for (const Graph& q : {p, random_graph(random, 6), random_graph(random, 2)}) {
    const double s = similarity(p, q);
    CHECK(s >= 0.0);
    CHECK(s <= 1.0);
    CHECK(similarity(q, p) == s);
  }
}

}  // namespace laws
