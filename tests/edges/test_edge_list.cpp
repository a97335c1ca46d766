// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <random>
#include <set>
#include <utility>

#include <topobag/edges/edge_list.hpp>

#include "catch.hpp"

using namespace topobag;

TEST_CASE("an edge has its smaller end first", "[edges]") {
  const Edge edge = make_edge(node_index(7), node_index(3));
  CHECK(edge.a == node_index(3));
  CHECK(edge.b == node_index(7));
  CHECK(edge == make_edge(node_index(3), node_index(7)));
  CHECK(edge != make_edge(node_index(3), node_index(6)));
}

TEST_CASE("edges are ordered by their ends", "[edges]") {
  const auto edge = [](std::size_t i, std::size_t j) {
    return make_edge(node_index(i), node_index(j));
  };
  CHECK(edge(0, 9) < edge(1, 2));
  CHECK(edge(1, 2) < edge(1, 3));
  CHECK_FALSE(edge(1, 2) < edge(1, 2));
}

TEST_CASE("a canonical list is the sorted set of its edges", "[edges]") {
  std::mt19937 random(21);
  for (std::size_t count = 0; count < 60; ++count) {
    EdgeList edges;
    std::set<std::pair<std::size_t, std::size_t>> expected;
    for (std::size_t n = 0; n < count; ++n) {
      const std::size_t i = random() % 6, j = 6 + random() % 4;
      edges.push_back(make_edge(node_index(i), node_index(j)));
      expected.emplace(i, j);
    }
    make_canonical(edges);
    REQUIRE(edges.size() == expected.size());
    CHECK(std::equal(edges.begin(), edges.end(), expected.begin(), [](const Edge& e, auto pair) {
      return value(e.a) == pair.first && value(e.b) == pair.second;
    }));
  }
}
