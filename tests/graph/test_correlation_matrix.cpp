// SPDX-License-Identifier: MIT
#include <topobag/graph/correlation_matrix.hpp>

#include "catch.hpp"
#include "random_graphs.hpp"

using namespace topobag;

TEST_CASE("eq. 6 and 8 on hand-computed numbers", "[graph][paper]") {
  std::vector<SemanticNode<>> nodes(3);
  nodes[0].position = Eigen::Vector3d(0, 0, 1);
  nodes[1].position = Eigen::Vector3d(3, 4, 1);
  nodes[2].position = Eigen::Vector3d(0, 0, 3);
  const TopologyGraph<> graph(
      nodes, {make_edge(node_index(0), node_index(1)), make_edge(node_index(2), node_index(0))});
  Eigen::Matrix3d expected;
  expected << 1, 5, 2, 5, 1, 0, 2, 0, 1;
  CHECK(correlation_matrix(graph) == expected);
  CHECK(Eigen::MatrixXd(sparse_correlation_matrix(graph)) == expected);
}

TEST_CASE("D of random graphs: symmetric, 1 on the diagonal, dense equals sparse", "[graph]") {
  std::mt19937 random(21);
  for (std::size_t n = 0; n < 25; ++n) {
    const TopologyGraph<> graph = random_graph(random, n, 4, false);
    const Eigen::MatrixXd D = correlation_matrix(graph);
    CHECK(D == D.transpose());
    CHECK(D.diagonal() == Eigen::VectorXd::Ones(static_cast<Eigen::Index>(n)));
    CHECK(Eigen::MatrixXd(sparse_correlation_matrix(graph)) == D);
    const auto stored = static_cast<std::size_t>(sparse_correlation_matrix(graph).nonZeros());
    CHECK(stored == n + 2 * graph.edges().size());
  }
}

TEST_CASE("an edge of length 0 looks like no edge in D", "[graph]") {
  std::vector<SemanticNode<>> nodes(2);
  nodes[0].position = nodes[1].position = Eigen::Vector3d(1, 1, 1);
  const TopologyGraph<> graph(nodes, {make_edge(node_index(0), node_index(1))});
  CHECK(correlation_matrix(graph) == Eigen::Matrix2d::Identity());
}
