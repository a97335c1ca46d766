// SPDX-License-Identifier: MIT
#include <topobag/graph/topology_weight.hpp>

#include "catch.hpp"
#include "random_graphs.hpp"

using namespace topobag;

TEST_CASE("eq. 9 and 10 on hand-computed numbers", "[graph][paper]") {
  std::vector<SemanticNode<>> nodes(3);
  nodes[0].label = ClassId{1};
  nodes[0].pixel = Eigen::Vector2d(100, 200);
  nodes[0].z = 1.0;
  nodes[0].position = Eigen::Vector3d(0, 0, 1);
  nodes[1].label = ClassId{3};
  nodes[1].pixel = Eigen::Vector2d(400, 300);
  nodes[1].z = 1.0;
  nodes[1].position = Eigen::Vector3d(3, 4, 1);
  nodes[2].label = ClassId{9};
  nodes[2].pixel = Eigen::Vector2d(10, 20);
  nodes[2].z = 3.0;
  nodes[2].position = Eigen::Vector3d(0, 0, 3);
  const TopologyGraph<> graph(
      nodes, {make_edge(node_index(0), node_index(1)), make_edge(node_index(0), node_index(2))});
  // D = [1 5 2; 5 1 0; 2 0 1].
  Eigen::Matrix<double, 3, 4> expected;
  expected << 100 + 2000 + 20, 200 + 1500 + 40, 1 + 5 + 6, 1 + 15 + 18,  //
      500 + 400, 1000 + 300, 5 + 1, 5 + 3,                               //
      200 + 10, 400 + 20, 2 + 3, 2 + 9;
  CHECK(topology_weight(graph) == expected);
  CHECK(sparse_topology_weight(graph) == expected);
  expected.col(2) *= 1000.0;
  CHECK(topology_weight(graph, 1000.0) == expected);
}

TEST_CASE("W of random graphs: dense equals sparse", "[graph]") {
  std::mt19937 random(31);
  for (std::size_t n = 0; n < 40; ++n) {
    const TopologyGraph<> graph = random_graph(random, n, 4, false);
    const auto W = topology_weight(graph);
    CHECK(W.rows() == static_cast<Eigen::Index>(n));
    CHECK((W - sparse_topology_weight(graph)).norm() <= 1e-12 * W.norm());
  }
}

TEST_CASE("permuting the nodes permutes the rows of W", "[graph]") {
  std::mt19937 random(32);
  for (std::size_t n = 1; n < 25; ++n) {
    const TopologyGraph<> graph = random_graph(random, n, 4, false);
    const auto order = random_order(random, n);
    const auto W = topology_weight(graph);
    const auto W_permuted = topology_weight(permuted(graph, order));
    for (std::size_t i = 0; i < n; ++i) {
      const Eigen::RowVector4d row = W.row(static_cast<Eigen::Index>(i));
      CHECK((row - W_permuted.row(static_cast<Eigen::Index>(order[i]))).norm() <=
            1e-12 * row.norm());
    }
  }
}

TEST_CASE("a graph without edges has W = O", "[graph]") {
  std::mt19937 random(33);
  const TopologyGraph<> graph(random_nodes(random, 9));
  CHECK(topology_weight(graph) == vertex_matrix(graph));
}
