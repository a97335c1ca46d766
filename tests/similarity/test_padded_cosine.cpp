// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>

#include <topobag/similarity/padded_cosine.hpp>

#include "catch.hpp"

using namespace topobag;

namespace {

SemanticNode<> node(int label, Eigen::Vector2d pixel, Eigen::Vector3d position) {
  SemanticNode<> n;
  n.label = ClassId{label};
  n.pixel = pixel;
  n.z = position.z();
  n.position = position;
  return n;
}

/// One node of each graph of class 1, so W = O = [u v z c].
TopologyGraph<> single(int label, double u, double v, double z) {
  return TopologyGraph<>({node(label, {u, v}, {0, 0, z})});
}

}  // namespace

TEST_CASE("eq. 12 on hand-computed rows", "[similarity][paper]") {
  const PaddedCosine similarity;
  // <(3, 4, 0, 12), (4, 3, 0, 12)> = 168 and both have length 13.
  CHECK(similarity(single(12, 3, 4, 0), single(12, 4, 3, 0)) == Approx(168.0 / 169.0));
  // eq. 11: the second row of the larger graph meets a padded zero row.
  const TopologyGraph<> two({node(12, {3, 4}, {0, 0, 0}), node(1, {9, 9}, {1, 0, 0})});
  CHECK(similarity(single(12, 4, 3, 0), two) == Approx(168.0 / 169.0 / 2.0));
}

TEST_CASE("an edge mixes the rows by its length", "[similarity][paper]") {
  // D = [1 2; 2 1], so W = [1 0 0 1; 0 1 0 1] + 2 [0 1 0 1; 1 0 0 1] = [1 2 0 3; 2 1 0 3].
  const TopologyGraph<> p({node(1, {1, 0}, {0, 0, 0}), node(1, {0, 1}, {2, 0, 0})},
                          {make_edge(node_index(0), node_index(1))});
  // W = O = [1 0 0 1].
  CHECK(PaddedCosine{}(p, single(1, 1, 0, 0)) ==
        Approx(4.0 / std::sqrt(14.0) / std::sqrt(2.0) / 2.0));
}

TEST_CASE("the raw reading of z scales the third column by F", "[similarity][paper]") {
  const auto p = single(1, 100, 0, 1), q = single(1, 0, 100, 1);
  CHECK(PaddedCosine{}(p, q) == Approx(2.0 / 10002.0));
  PaddedCosine raw;
  raw.depth_scale = 5000.0;
  CHECK(raw(p, q) == Approx((25e6 + 1.0) / (25e6 + 10001.0)));
}

TEST_CASE("the readings of the row order", "[similarity][paper]") {
  const auto a = node(1, {100, 0}, {0, 0, 0}), b = node(2, {0, 100}, {0, 0, 0});
  const TopologyGraph<> p({a, b}), q({b, a});
  PaddedCosine similarity;
  // As the detector ordered them, unlike objects meet: 2 / sqrt(10001 · 10004) in both rows.
  CHECK(similarity(p, q) == Approx(2.0 / std::sqrt(10001.0 * 10004.0)));
  similarity.row_order = RowOrder::class_then_position;
  CHECK(similarity(p, q) == Approx(1.0));
  similarity.row_order = RowOrder::assignment;
  CHECK(similarity(p, q) == Approx(1.0));

  // Sorted by u, the two cups of s meet the wrong ones of r; the assignment finds the right ones.
  const TopologyGraph<> r({node(1, {1, 900}, {0, 0, 0}), node(1, {2, 1}, {0, 0, 0})});
  const TopologyGraph<> s({node(1, {1, 900}, {0, 0, 0}), node(1, {0.5, 0.25}, {0, 0, 0})});
  similarity.row_order = RowOrder::class_then_position;
  const double sorted = similarity(r, s);
  similarity.row_order = RowOrder::assignment;
  CHECK(similarity(r, s) > sorted + 0.3);
}

TEST_CASE("rows that mean nothing contribute nothing", "[similarity]") {
  const PaddedCosine similarity;
  const TopologyGraph<> empty;
  CHECK(similarity(empty, empty) == 0.0);
  CHECK(similarity(empty, single(1, 1, 1, 1)) == 0.0);
  CHECK(similarity(single(0, 0, 0, 0), single(0, 0, 0, 0)) == 0.0);
  const double huge = std::numeric_limits<double>::max();
  const TopologyGraph<> overflow({node(1, {huge, huge}, {huge, 0, 0}), node(1, {1, 1}, {0, 0, 0})},
                                 {make_edge(node_index(0), node_index(1))});
  CHECK(similarity(overflow, overflow) == 0.0);
  CHECK(similarity(single(1, huge / 4, huge / 4, 1), single(1, huge / 4, huge / 4, 1)) ==
        Approx(1.0));
}

TEST_CASE("the cosine is negative where pixels are", "[similarity]") {
  CHECK(PaddedCosine{}(single(1, 100, 0, 0), single(1, -100, 0, 0)) < -0.99);
}
