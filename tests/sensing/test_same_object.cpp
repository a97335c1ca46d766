// SPDX-License-Identifier: MIT
#include <topobag/sensing/same_object.hpp>

#include "catch.hpp"

using namespace topobag;

namespace {

/// A node of size 0.3 m × 0.4 m times `scale`: a diagonal of half a metre.
SemanticNode<> node_at(double x, double scale = 1.0, int label = 1) {
  SemanticNode<> node;
  node.label = ClassId{label};
  node.position = Eigen::Vector3d(x, 0.0, 3.0);
  node.size = {0.3 * scale, 0.4 * scale};
  return node;
}

}  // namespace

TEST_CASE("two nodes are one object when they lie together, of whatever class", "[sensing]") {
  const SameObject same;  // a fifth of 0.5 m
  CHECK(same(node_at(0.0), node_at(0.099)));
  CHECK(same(node_at(0.0), node_at(0.0, 1.0, 7)));
  CHECK_FALSE(same(node_at(0.0), node_at(0.101)));
}

TEST_CASE("the smaller object decides how near is near", "[sensing]") {
  const SameObject same;
  CHECK(same(node_at(0.0), node_at(0.099, 1.6)));
  CHECK_FALSE(same(node_at(0.0), node_at(0.101, 1.6)));
  CHECK_FALSE(same(node_at(0.0, 1.6), node_at(0.101)));
}

TEST_CASE("objects of very different size are two", "[sensing]") {
  const SameObject same;
  CHECK(same(node_at(0.0), node_at(0.0, 1.69)));
  CHECK_FALSE(same(node_at(0.0), node_at(0.0, 1.71)));
  CHECK_FALSE(same(node_at(0.0, 1.71), node_at(0.0)));
}

TEST_CASE("an unknown position or size is no object's own", "[sensing]") {
  const SameObject same;
  SemanticNode<> unplaced = node_at(0.0), unsized = node_at(0.0);
  unplaced.position.reset();
  unsized.size.setZero();
  CHECK_FALSE(same(unplaced, node_at(0.0)));
  CHECK_FALSE(same(node_at(0.0), unplaced));
  CHECK_FALSE(same(unsized, node_at(0.0)));
  CHECK_FALSE(same(unsized, unsized));
}

TEST_CASE("the same rule holds in single precision", "[sensing]") {
  SemanticNode<float> a, b;
  a.position = Eigen::Vector3f(0, 0, 1);
  b.position = Eigen::Vector3f(0.09F, 0, 1);
  a.size = b.size = {0.3F, 0.4F};
  CHECK(SameObject{}(a, b));
  CHECK_FALSE(SameObject{0.1}(a, b));
}
