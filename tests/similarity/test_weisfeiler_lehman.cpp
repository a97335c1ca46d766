// SPDX-License-Identifier: MIT
#include <cmath>

#include <topobag/similarity/weisfeiler_lehman.hpp>

#include "catch.hpp"
#include "similarity/small_graphs.hpp"

using namespace topobag;

TEST_CASE("the subtree kernel on hand-computed graphs", "[similarity]") {
  const auto path = graph_of({node_at(1), node_at(2), node_at(1)}, {{0, 1}, {1, 2}});
  const auto edge = graph_of({node_at(1), node_at(2), node_at(1)}, {{0, 1}});
  WeisfeilerLehman similarity;
  similarity.iterations = 0;
  CHECK(similarity(path, edge) == Approx(1.0));
  // Refined: path 1(2) twice, 2(11); edge 1(2), 2(1), 1(). Products: counts 2·2 + 1·1 and 2·1.
  similarity.iterations = 1;
  CHECK(similarity(path, edge) == Approx(7.0 / std::sqrt((5.0 + 5.0) * (5.0 + 3.0))));
}

TEST_CASE("a second iteration sees what lies two edges away", "[similarity]") {
  // Both have two nodes of degree 1 and four of degree 2, of one class.
  const auto path =
      graph_of({node_at(1), node_at(1), node_at(1), node_at(1), node_at(1), node_at(1)},
               {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 5}});
  const auto triangle_and_path =
      graph_of({node_at(1), node_at(1), node_at(1), node_at(1), node_at(1), node_at(1)},
               {{0, 1}, {1, 2}, {2, 0}, {3, 4}, {4, 5}});
  WeisfeilerLehman similarity;
  similarity.iterations = 1;
  CHECK(similarity(path, triangle_and_path) == Approx(1.0));
  similarity.iterations = 2;
  CHECK(similarity(path, triangle_and_path) < 0.99);
}

TEST_CASE("no more iterations are counted than there is room for", "[similarity][regression]") {
  const auto graph = graph_of({node_at(1), node_at(2)}, {{0, 1}});
  WeisfeilerLehman similarity;
  similarity.iterations = WeisfeilerLehman::max_iterations;
  CHECK(similarity(graph, graph) == Approx(1.0));
  similarity.iterations = ~std::size_t{0};
  CHECK_THROWS_AS(similarity.descriptor(graph), InvalidValue);
}
