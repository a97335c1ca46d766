// SPDX-License-Identifier: MIT
#include <cmath>

#include <topobag/similarity/affinity_cosine.hpp>

#include "catch.hpp"
#include "similarity/small_graphs.hpp"

using namespace topobag;

TEST_CASE("W = A · C on hand-computed numbers", "[similarity]") {
  AffinityCosine similarity;
  similarity.sigma = 0.5;
  const auto p = graph_of({node_at(1), node_at(2, 1.0)}, {{0, 1}});
  const auto q = graph_of({node_at(1), node_at(2, 1.0)});
  // Rows of p: (1, a) and (a, 1) with a = e⁻²; of q, without an edge: (1, 0) and (0, 1).
  const double a = std::exp(-2.0);
  CHECK(similarity(p, q) == Approx(1.0 / std::sqrt(1.0 + a * a)));
  // One node against two: one row of two meets one.
  CHECK(similarity(graph_of({node_at(1)}), p) == Approx(0.5 / std::sqrt(1.0 + a * a)));
}

TEST_CASE("near neighbours weigh more than far ones", "[similarity]") {
  const AffinityCosine similarity;
  const auto alone = graph_of({node_at(1)});
  double last = 0.0;
  for (const double distance : {0.0, 0.2, 0.5, 1.0, 3.0}) {
    const double s = similarity(alone, graph_of({node_at(1), node_at(2, distance)}, {{0, 1}}));
    CHECK(s > last);
    last = s;
  }
}

TEST_CASE("class vectors make neighbours of kindred classes kindred", "[similarity]") {
  const auto p = graph_of({node_at(1), node_at(2)}, {{0, 1}});
  const auto q = graph_of({node_at(1), node_at(3)}, {{0, 1}});
  AffinityCosine similarity;
  // Rows (1, 1, 0) and (1, 0, 1) of the one common class.
  CHECK(similarity(p, q) == Approx(0.5 / 2.0));
  similarity.vectors.set(ClassId{2}, Eigen::Vector2d(1.0, 0.0));
  similarity.vectors.set(ClassId{3}, Eigen::Vector2d(0.6, 0.8));
  CHECK(similarity(p, q) == Approx((1.0 + 0.6) / 2.0 / 2.0));
  // Opposite neighbours cancel the class itself to (1, −1): a negative or zero cosine counts as 0.
  similarity.vectors.set(ClassId{3}, Eigen::Vector2d(-1.0, 0.0));
  CHECK(similarity(p, q) == 0.0);
}

TEST_CASE("class weights say which nodes count", "[similarity]") {
  AffinityCosine similarity;
  const auto p = graph_of({node_at(1), node_at(2)});
  const auto q = graph_of({node_at(1), node_at(3)});
  CHECK(similarity(p, q) == Approx(0.5));
  similarity.weights.set(ClassId{1}, 3.0);
  CHECK(similarity(p, q) == Approx(0.75));
}
