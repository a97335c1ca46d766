// SPDX-License-Identifier: MIT
#include <cmath>

#include <topobag/similarity/class_histogram.hpp>

#include "catch.hpp"
#include "similarity/small_graphs.hpp"

using namespace topobag;

TEST_CASE("class counts on hand-computed numbers", "[similarity]") {
  // Counts (2, 1, 0) and (1, 0, 2).
  const auto p = graph_of({node_at(1), node_at(2), node_at(1)});
  const auto q = graph_of({node_at(3), node_at(1), node_at(3)});
  ClassHistogram similarity;
  CHECK(similarity(p, q) == Approx(1.0 / 5.0));
  similarity.measure = HistogramMeasure::cosine;
  CHECK(similarity(p, q) == Approx(2.0 / 5.0));
}

TEST_CASE("tf-idf: the weights multiply the counts", "[similarity]") {
  const auto p = graph_of({node_at(1), node_at(2), node_at(1)});
  const auto q = graph_of({node_at(3), node_at(1), node_at(3)});
  ClassHistogram similarity;
  similarity.measure = HistogramMeasure::cosine;
  similarity.weights.set(ClassId{1}, 0.5);
  // (1, 1, 0) and (.5, 0, 2).
  CHECK(similarity(p, q) == Approx(0.5 / std::sqrt(2.0 * 4.25)));
}
