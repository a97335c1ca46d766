// SPDX-License-Identifier: MIT
#include <cstddef>
#include <random>
#include <vector>

#include <topobag/edges/complete_edges.hpp>
#include <topobag/edges/radius_edges.hpp>

#include "catch.hpp"
#include "random_graphs.hpp"

using namespace topobag;

TEST_CASE("radius edges are the complete graph's short ones", "[edges]") {
  std::mt19937 random(24);
  for (std::size_t round = 0; round < 300; ++round) {
    const auto nodes = random_nodes(random, round % 14, 4, round % 2 == 0);
    for (const double radius : {0.0, 0.8, 2.0}) {
      EdgeList expected;
      for (const Edge& edge : CompleteEdges{}(nodes)) {
        const auto &a = nodes[value(edge.a)], &b = nodes[value(edge.b)];
        if (!a.position || !b.position) continue;
        if ((*a.position - *b.position).norm() <= radius) expected.push_back(edge);
      }
      REQUIRE(RadiusEdges{radius}(nodes) == expected);
    }
  }
}

TEST_CASE("a distance of just the radius is an edge, coincident nodes always", "[edges]") {
  std::vector<SemanticNode<>> nodes(3);
  nodes[0].position = Eigen::Vector3d(0, 0, 1);
  nodes[1].position = Eigen::Vector3d(3, 4, 1);
  nodes[2].position = Eigen::Vector3d(0, 0, 1);
  CHECK(RadiusEdges{5.0}(nodes).size() == 3);
  CHECK(RadiusEdges{4.999}(nodes) == EdgeList{{node_index(0), node_index(2)}});
  CHECK(RadiusEdges{0.0}(nodes) == EdgeList{{node_index(0), node_index(2)}});
}
