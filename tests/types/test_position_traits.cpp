// SPDX-License-Identifier: MIT
#include <topobag/types/position_traits.hpp>

#include "catch.hpp"

using namespace topobag;

namespace {
struct Tree {
  int row = 0;
  int column = 0;
};
struct Cloud {};
struct River {};
}  // namespace

template <>
struct topobag::PositionTraits<Tree> {
  static Eigen::Vector2d position(const Tree& tree) {
    return {double(tree.column), double(tree.row)};
  }
};
template <>
struct topobag::PositionTraits<River> {
  static const char* position(const River&) { return "everywhere"; }
};

TEST_CASE("a position comes from a trait", "[types][delaunay]") {
  STATIC_REQUIRE(has_position_v<Tree>);
  STATIC_REQUIRE(has_position_v<Eigen::Vector2d>);
  STATIC_REQUIRE(has_position_v<Eigen::Vector2f>);
  STATIC_REQUIRE(has_position_v<SemanticNode<float>>);
  STATIC_REQUIRE_FALSE(has_position_v<Eigen::Vector3d>);
  STATIC_REQUIRE_FALSE(has_position_v<Cloud>);
  STATIC_REQUIRE_FALSE(has_position_v<River>);
  CHECK(PositionTraits<Tree>::position({3, 4}) == Eigen::Vector2d(4, 3));
  CHECK(PositionTraits<Eigen::Vector2f>::position({0.5f, 2.0f}) == Eigen::Vector2d(0.5, 2.0));
}

TEST_CASE("a node's position is its pixel, or nowhere", "[types][delaunay]") {
  SemanticNode<> node;
  CHECK(PositionTraits<SemanticNode<>>::position(node).array().isNaN().all());
  node.pixel = Eigen::Vector2d(5, 6);
  CHECK(PositionTraits<SemanticNode<>>::position(node) == Eigen::Vector2d(5, 6));
}
