// SPDX-License-Identifier: MIT
#include <cmath>

#include <topobag/similarity/label_walks.hpp>

#include "catch.hpp"
#include "random_graphs.hpp"
#include "similarity/small_graphs.hpp"

using namespace topobag;

TEST_CASE("walk probabilities on a hand-computed path", "[similarity]") {
  // Path 1 – 2 – 3. From the middle: "2" 1, "21" ½, "23" ½. From the ends: "1" 1, "12" 1.
  const auto path = graph_of({node_at(1), node_at(2), node_at(3)}, {{0, 1}, {1, 2}});
  const auto middle = graph_of({node_at(2), node_at(1)}, {{0, 1}});  // "2" 1, "21" 1; "1" 1, "12" 1
  LabelWalks similarity;
  similarity.length = 2;
  const double twos = 1.5 / std::sqrt(1.5 * 2.0);
  CHECK(similarity(path, middle) == Approx((1.0 + twos) / 3.0));

  similarity.length =
      3;  // the path adds "212" ½, "232" ½ and "121" ½, "123" ½; the pair "212", "121"
  const double longer = (1.0 + 0.5 + 0.5) / std::sqrt(2.0 * 3.0);
  CHECK(similarity(path, middle) == Approx((2.5 / std::sqrt(2.5 * 3.0) + longer) / 3.0));

  similarity.length = 1;
  CHECK(similarity(path, middle) == Approx(2.0 / 3.0));
}

TEST_CASE("the probabilities of all strings of one length sum to 1", "[similarity]") {
  std::mt19937 random(4);
  // Every node of these graphs has a neighbour, and all share one class: one string per length.
  for (std::size_t n = 2; n < 10; ++n) {
    const NodeHistograms walks = LabelWalks{}.descriptor(random_graph(random, n, 1));
    for (const SparseHistogram& h : walks.histograms()) {
      REQUIRE(h.entries().size() == 3);
      for (const auto& entry : h.entries()) CHECK(entry.weight == Approx(1.0 / std::sqrt(3.0)));
    }
  }
}

TEST_CASE("walks that are too long to be listed are refused, not walked",
          "[similarity][regression]") {
  std::mt19937 random(3);
  const TopologyGraph<> graph = random_graph(random, 3, 2);
  LabelWalks similarity;
  for (const std::size_t length : {std::size_t{0}, LabelWalks::max_length + 1, ~std::size_t{0}}) {
    similarity.length = length;
    CHECK_THROWS_AS(similarity.descriptor(graph), InvalidValue);
  }
  similarity.length = LabelWalks::max_length;
  CHECK(similarity(graph, graph) == Approx(1.0));
}
