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
  // 1.0 m falls into bin 2; 1.125 m gives .75 to bin 2 and .25 to bin 3; the classes share .2.
  CHECK(similarity(pair_apart(1, 2, 1.0), pair_apart(2, 1, 1.125)) == Approx(0.95 / 1.45));
  // Another class, another distance: what is left is the class vote.
  CHECK(similarity(pair_apart(1, 2, 1.0), pair_apart(1, 3, 1.0)) == Approx(0.1 / 2.3));
  CHECK(similarity(pair_apart(1, 2, 1.0), pair_apart(1, 2, 3.0)) == Approx(0.2 / 2.2));
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

TEST_CASE("a descriptor holds a vote for each class and softly for each pair", "[similarity]") {
  const SparseHistogram h = ClassPairDistanceHistogram{}.descriptor(pair_apart(1, 2, 0.55));
  CHECK(h.entries().size() == 4);
  CHECK(h.total() == Approx(1.2));
}

TEST_CASE("class weights multiply the votes", "[similarity]") {
  ClassPairDistanceHistogram similarity;
  similarity.bin_width = 0.5;
  similarity.weights.set(ClassId{1}, 4.0);
  // Votes .4, .1 and sqrt(4 · 1); the other pair's distance is another, so .5 is common of 2.5
  // each.
  CHECK(similarity(pair_apart(1, 2, 1.0), pair_apart(1, 2, 3.0)) == Approx(0.5 / 4.5));
}

TEST_CASE("sizes vote for their octave", "[similarity]") {
  const auto sized = [](double width_m, double height_m) {
    SemanticNode<> n = node(1, 0.0);
    n.size = {width_m, height_m};
    return TopologyGraph<>({n});
  };
  ClassPairDistanceHistogram similarity;
  similarity.class_vote = 0.25;
  similarity.size_bin = 1.0;
  // One octave apart in width, a quarter in height: .25 and .75 in common of 2.25 each.
  const double s = similarity(sized(0.016, 0.032), sized(0.032, 0.032 * std::exp2(0.25)));
  CHECK(s == Approx(1.0 / 3.5));
  // An unknown size casts no vote.
  CHECK(similarity(sized(0.016, 0.032), sized(0.0, 0.032)) == Approx(1.25 / 2.25));
  similarity.size_vote = 0.0;
  CHECK(similarity(sized(0.016, 0.032), sized(2.0, 3.0)) == 1.0);
}
