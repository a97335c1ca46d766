// SPDX-License-Identifier: MIT
#include <cmath>

#include <topobag/similarity/semantic_subgraph.hpp>

#include "catch.hpp"
#include "similarity/small_graphs.hpp"

using namespace topobag;

namespace {

SemanticNode<> sized(int label, double width, double height, double place = 0.0) {
  SemanticNode<> node = node_at(label, place);
  node.size = {width, height};
  return node;
}

}  // namespace

TEST_CASE("box shapes on hand-computed numbers", "[similarity]") {
  const SemanticSubgraph similarity;
  CHECK(similarity(graph_of({sized(1, 2, 3)}), graph_of({sized(1, 4, 2)})) == Approx(1.0 / 3.0));
  CHECK(similarity(graph_of({sized(1, 2, 3)}), graph_of({sized(1, 0, 0)})) == 1.0);
  CHECK(similarity(graph_of({sized(1, 2, 3)}), graph_of({sized(2, 2, 3)})) == 0.0);
  // An unknown size on either side.
  CHECK(similarity(graph_of({sized(1, 2, 0), sized(2, 0, 3)}),
                   graph_of({sized(1, 0, 3), sized(2, 2, 0)})) == Approx(1.0));
}

TEST_CASE("distances of a sub-graph on hand-computed numbers", "[similarity]") {
  SemanticSubgraph similarity;
  similarity.bin_width = 1.0;
  // Around each node: itself at 0 and the other at 2, against 2.5, half in bin 2 and half in bin 3.
  const auto p = graph_of({sized(1, 1, 1), sized(2, 1, 1, 2.0)});
  const auto q = graph_of({sized(1, 1, 1), sized(2, 1, 1, 2.5)});
  CHECK(similarity(p, q) == Approx(1.5 / std::sqrt(2.0 * 1.5)));
  // Only one of two finds a partner.
  CHECK(similarity(p, graph_of({sized(1, 1, 1)})) == Approx(std::sqrt(0.5) / 2.0));
}

TEST_CASE("nodes go to the partners that fit best in all", "[similarity]") {
  const SemanticSubgraph similarity;
  const auto p = graph_of({sized(1, 1, 1), sized(1, 4, 4, 50.0)});
  const auto q = graph_of({sized(1, 4, 4), sized(1, 1, 1, 50.0)});
  CHECK(similarity(p, q) == Approx(1.0));
}

TEST_CASE("a node without a position is compared by its shape", "[similarity]") {
  SemanticNode<> unplaced = sized(1, 2, 3);
  unplaced.position.reset();
  const SemanticSubgraph similarity;
  CHECK(similarity(graph_of({unplaced}), graph_of({unplaced})) == 1.0);
}
