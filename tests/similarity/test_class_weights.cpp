// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>
#include <vector>

#include <topobag/graph/topology_graph.hpp>
#include <topobag/similarity/class_histogram.hpp>
#include <topobag/similarity/class_weights.hpp>

#include "catch.hpp"

using namespace topobag;

namespace {

TopologyGraph<> of_classes(std::initializer_list<int> labels) {
  std::vector<SemanticNode<>> nodes(labels.size());
  std::size_t i = 0;
  for (const int label : labels) nodes[i++].label = ClassId{label};
  return TopologyGraph<>(nodes);
}

}  // namespace

TEST_CASE("classes weigh 1 until set", "[similarity]") {
  ClassWeights weights;
  CHECK(weights(ClassId{5}) == 1.0);
  weights.set(ClassId{5}, 0.25);
  CHECK(weights(ClassId{5}) == 0.25);
  CHECK(weights(ClassId{6}) == 1.0);
}

TEST_CASE("idf counts the graphs that hold a class, not its nodes", "[similarity]") {
  const std::vector<TopologyGraph<>> background{of_classes({1, 1, 2}), of_classes({1}),
                                                of_classes({1, 3})};
  const ClassWeights weights = ClassWeights::idf(background);
  CHECK(weights(ClassId{1}) == Approx(1.0));
  CHECK(weights(ClassId{2}) == Approx(1.0 + std::log(2.0)));
  CHECK(weights(ClassId{3}) == Approx(1.0 + std::log(2.0)));
  CHECK(weights(ClassId{4}) == Approx(1.0 + std::log(4.0)));
  CHECK(ClassWeights::idf(std::vector<TopologyGraph<>>{})(ClassId{1}) == 1.0);
}

TEST_CASE("a weight has to be finite and not negative", "[similarity]") {
  ClassWeights weights;
  weights.set(ClassId{1}, 2.0);
  CHECK_THROWS_AS(weights.set(ClassId{1}, -1.0), InvalidValue);
  CHECK_THROWS_AS(weights.set(ClassId{1}, std::numeric_limits<double>::infinity()), InvalidValue);
  CHECK_THROWS_AS(weights.set(ClassId{1}, std::numeric_limits<double>::quiet_NaN()), InvalidValue);
  CHECK(weights(ClassId{1}) == 2.0);
  CHECK_NOTHROW(weights.set(ClassId{1}, 0.0));
}

TEST_CASE("the largest weight keeps sums of squares finite, and a larger one is refused",
          "[similarity][regression]") {
  ClassWeights weights;
  CHECK_THROWS_AS(weights.set(ClassId{1}, 1.0001e100), InvalidValue);
  weights.set(ClassId{1}, 1e100);
  const TopologyGraph<> graph = of_classes({1, 1, 2});
  CHECK(ClassHistogram{HistogramMeasure::cosine, weights}(graph, graph) == Approx(1.0));
}
