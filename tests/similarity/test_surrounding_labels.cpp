// SPDX-License-Identifier: MIT
#include <cmath>

#include <topobag/similarity/surrounding_labels.hpp>

#include "catch.hpp"
#include "similarity/small_graphs.hpp"

using namespace topobag;

TEST_CASE("neighbours' labels on hand-computed graphs", "[similarity]") {
  // Around 1: {2, 2, 3} and {2, 3}; around each 2 and 3: {1}.
  const auto p =
      graph_of({node_at(1), node_at(2), node_at(2), node_at(3)}, {{0, 1}, {0, 2}, {0, 3}});
  const auto q = graph_of({node_at(1), node_at(2), node_at(3)}, {{0, 1}, {0, 2}});
  SurroundingLabels similarity;
  CHECK(similarity(p, q) == Approx((3.0 / std::sqrt(5.0 * 2.0) + 1.0 + 1.0) / 4.0));
  similarity.weights.set(ClassId{2}, 0.5);
  CHECK(similarity(p, q) == Approx((1.5 / std::sqrt(2.0 * 1.25) + 1.0 + 1.0) / 4.0));
}

TEST_CASE("pairs of labels along two edges on hand-computed graphs", "[similarity]") {
  SurroundingLabels similarity;
  similarity.counted = Surroundings::neighbor_pairs;
  // Triangle 1 2 3: around 1 the pairs 23 and 32. Path 1 – 2 – 3: around 1 the pair 23, around 2
  // none, around 3 the pair 21.
  const auto triangle = graph_of({node_at(1), node_at(2), node_at(3)}, {{0, 1}, {1, 2}, {0, 2}});
  const auto path = graph_of({node_at(1), node_at(2), node_at(3)}, {{0, 1}, {1, 2}});
  CHECK(similarity(triangle, path) == Approx((std::sqrt(0.5) + 0.0 + std::sqrt(0.5)) / 3.0));
  // A longer path: around 1 the pairs 23 and 24, of which the other graph has the first alone.
  const auto fork =
      graph_of({node_at(1), node_at(2), node_at(3), node_at(4)}, {{0, 1}, {1, 2}, {1, 3}});
  similarity.weights.set(ClassId{2}, 0.5);
  similarity.weights.set(ClassId{4}, 3.0);
  const double around_1 = 0.5 / std::sqrt(0.5 * 0.5 + 1.5 * 1.5);
  // Around 3 the pairs 21 and 24, of which the other graph has the first; around 2 both have none.
  CHECK(similarity(fork, path) == Approx((around_1 + 1.0 + around_1) / 4.0));
}
