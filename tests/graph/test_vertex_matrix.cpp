// SPDX-License-Identifier: MIT
#include <topobag/graph/vertex_matrix.hpp>

#include "catch.hpp"

using namespace topobag;

TEST_CASE("eq. 7: a row is u, v, z and the label number", "[graph][paper]") {
  std::vector<SemanticNode<>> nodes(2);
  nodes[0].label = ClassId{16};
  nodes[0].pixel = Eigen::Vector2d(320.5, 17.0);
  nodes[0].z = 1.5;
  nodes[1].label = ClassId{2};  // behind the camera: no pixel
  nodes[1].z = 2.0;
  const TopologyGraph<> graph(nodes);

  Eigen::Matrix<double, 2, 4> expected;
  expected << 320.5, 17.0, 1.5, 16.0, 0.0, 0.0, 2.0, 2.0;
  CHECK(vertex_matrix(graph) == expected);
  expected.col(2) *= 5000.0;
  CHECK(vertex_matrix(graph, 5000.0) == expected);
}

TEST_CASE("an empty graph has a matrix without rows", "[graph]") {
  CHECK(vertex_matrix(TopologyGraph<>{}).rows() == 0);
  CHECK(vertex_matrix(TopologyGraph<float>{}).cols() == 4);
}
