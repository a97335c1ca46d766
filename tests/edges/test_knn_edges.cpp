// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <random>
#include <vector>

#include <topobag/edges/complete_edges.hpp>
#include <topobag/edges/knn_edges.hpp>

#include "catch.hpp"
#include "random_graphs.hpp"

using namespace topobag;

namespace {

/// Whether fewer than k nodes come before j among the neighbours of i.
bool chooses(const std::vector<SemanticNode<>>& nodes, std::size_t i, std::size_t j,
             std::size_t k) {
  if (!nodes[i].position || !nodes[j].position) return false;
  const auto distance = [&](std::size_t n) {
    return (*nodes[i].position - *nodes[n].position).squaredNorm();
  };
  std::size_t before = 0;
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    if (n == i || n == j || !nodes[n].position) continue;
    if (distance(n) < distance(j) || (distance(n) == distance(j) && n < j)) ++before;
  }
  return before < k;
}

EdgeList knn_truth(const std::vector<SemanticNode<>>& nodes, std::size_t k) {
  EdgeList edges;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    for (std::size_t j = i + 1; j < nodes.size(); ++j) {
      if (chooses(nodes, i, j, k) || chooses(nodes, j, i, k)) {
        edges.push_back({node_index(i), node_index(j)});
      }
    }
  }
  return edges;
}

std::vector<SemanticNode<>> on_line(const std::vector<double>& xs) {
  std::vector<SemanticNode<>> nodes(xs.size());
  for (std::size_t i = 0; i < xs.size(); ++i) nodes[i].position = Eigen::Vector3d(xs[i], 0, 1);
  return nodes;
}

}  // namespace

TEST_CASE("nearest-neighbour edges equal brute force", "[edges]") {
  std::mt19937 random(22);
  for (std::size_t round = 0; round < 500; ++round) {
    auto nodes = random_nodes(random, round % 14, 4, round % 2 == 0);
    if (round % 3 == 0) {  // on a coarse grid, where distances tie and nodes coincide
      for (auto& node : nodes) {
        if (node.position) node.position = node.position->array().round().matrix();
      }
    }
    for (const std::size_t k : {0U, 1U, 3U, 20U}) {
      REQUIRE(KnnEdges{k}(nodes) == knn_truth(nodes, k));
    }
  }
}

TEST_CASE("with as many neighbours as nodes the graph is complete", "[edges]") {
  std::mt19937 random(23);
  const auto nodes = random_nodes(random, 9);
  CHECK(KnnEdges{8}(nodes) == CompleteEdges{}(nodes));
}

TEST_CASE("an edge stands when either end chose it", "[edges]") {
  // The far node chooses the nearest of the cluster, which has nearer ones.
  const EdgeList edges = KnnEdges{1}(on_line({0.0, 1.0, 5.0}));
  CHECK(edges == EdgeList{{node_index(0), node_index(1)}, {node_index(1), node_index(2)}});
}

TEST_CASE("equal distances go to the smaller index", "[edges]") {
  // Both neighbours of the middle node choose it; of the two it takes the first.
  auto nodes = on_line({0.0, -1.0, 1.0, -1.5, 1.5});
  CHECK(KnnEdges{1}(nodes) == EdgeList{{node_index(0), node_index(1)},
                                       {node_index(1), node_index(3)},
                                       {node_index(2), node_index(4)}});
}
