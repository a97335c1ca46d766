// SPDX-License-Identifier: MIT
#include <cmath>

#include <topobag/similarity/class_pair_distance_histogram.hpp>

#include "catch.hpp"

using namespace topobag;

namespace {

SemanticNode<> node(int label, double x) {
  SemanticNode<> n;
  n.label = ClassId{label};
  n.position = Eigen::Vector3d(x, 0, 0);
  return n;
}

TopologyGraph<> pair_apart(int label_a, int label_b, double distance) {
  return TopologyGraph<>({node(label_a, 0.0), node(label_b, distance)});
}

}  // namespace

TEST_CASE("class pairs and distances on hand-computed numbers", "[similarity]") {
  ClassPairDistanceHistogram similarity;
  similarity.bin_width = 0.5;
  similarity.class_vote = 0.1;
  // 1.0 m falls into bin 2; 1.125 m gives .75 to bin 2 and .25 to bin 3. The classes share .02.
  const double expected = (0.75 + 0.02) / std::sqrt((1.0 + 0.02) * (0.5625 + 0.0625 + 0.02));
  CHECK(similarity(pair_apart(1, 2, 1.0), pair_apart(2, 1, 1.125)) == Approx(expected));
  // Another class, another distance: what is left is the class vote.
  CHECK(similarity(pair_apart(1, 2, 1.0), pair_apart(1, 3, 1.0)) == Approx(0.01 / 1.02));
  CHECK(similarity(pair_apart(1, 2, 1.0), pair_apart(1, 2, 3.0)) == Approx(0.02 / 1.02));
}

TEST_CASE("distances beyond the largest are alike", "[similarity]") {
  const ClassPairDistanceHistogram similarity;
  CHECK(similarity(pair_apart(1, 2, 7.0), pair_apart(1, 2, 1e300)) == Approx(1.0));
}

TEST_CASE("graphs without two positions are compared by their classes", "[similarity]") {
  const ClassPairDistanceHistogram similarity;
  SemanticNode<> unplaced;
  unplaced.label = ClassId{1};
  CHECK(similarity(TopologyGraph<>({unplaced}), TopologyGraph<>({node(1, 5.0)})) == Approx(1.0));
  CHECK(similarity(TopologyGraph<>({node(1, 0)}), TopologyGraph<>({node(2, 0)})) == 0.0);
}

TEST_CASE("a descriptor is a unit histogram in ascending words", "[similarity]") {
  const SparseHistogram h = ClassPairDistanceHistogram{}.descriptor(pair_apart(1, 2, 0.55));
  CHECK(h.entries().size() == 4);
  CHECK(std::is_sorted(h.entries().begin(), h.entries().end()));
  CHECK(dot(h, h) == Approx(1.0));
}
