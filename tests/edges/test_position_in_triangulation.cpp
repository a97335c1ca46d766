// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>

#include <topobag/edges/position_in_triangulation.hpp>

#include "catch.hpp"

using namespace topobag;

TEST_CASE("a triangle starts at its smallest index and keeps its sense", "[edges][delaunay]") {
  const auto i = [](std::size_t k) { return node_index(k); };
  const Triangle left{i(1), i(5), i(9)}, right{i(1), i(9), i(5)};
  CHECK(make_triangle(i(1), i(5), i(9)) == left);
  CHECK(make_triangle(i(5), i(9), i(1)) == left);
  CHECK(make_triangle(i(9), i(1), i(5)) == left);
  CHECK(make_triangle(i(1), i(9), i(5)) == right);
  CHECK(make_triangle(i(9), i(5), i(1)) == right);
  CHECK(make_triangle(i(5), i(1), i(9)) == right);
  CHECK(left < right);
}

TEST_CASE("a directed edge knows its reverse", "[edges][delaunay]") {
  const DirectedEdge edge{node_index(2), node_index(1)};
  CHECK(edge.reversed() == DirectedEdge{node_index(1), node_index(2)});
  CHECK(edge.reversed() < edge);
  CHECK(edge.reversed() != edge);
}
