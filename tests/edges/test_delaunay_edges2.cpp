// SPDX-License-Identifier: MIT
#include <limits>

#include <topobag/edges/delaunay_edges2.hpp>

#include "catch.hpp"

using namespace topobag;

namespace {

std::vector<SemanticNode<>> nodes_at(const std::vector<Eigen::Vector2d>& pixels) {
  std::vector<SemanticNode<>> nodes(pixels.size());
  for (std::size_t i = 0; i < pixels.size(); ++i) nodes[i].pixel = pixels[i];
  return nodes;
}

EdgeList edges(std::initializer_list<std::pair<unsigned, unsigned>> pairs) {
  EdgeList list;
  for (const auto& [a, b] : pairs) list.push_back({node_index(a), node_index(b)});
  return list;
}

}  // namespace

TEST_CASE("Delaunay edges of the smallest layouts", "[edges][delaunay]") {
  const DelaunayEdges2 build;
  CHECK(build(nodes_at({})).empty());
  CHECK(build(nodes_at({{1, 2}})).empty());
  CHECK(build(nodes_at({{1, 2}, {3, 4}})) == edges({{0, 1}}));
  CHECK(build(nodes_at({{0, 0}, {1, 0}, {0, 1}})) == edges({{0, 1}, {0, 2}, {1, 2}}));
}

TEST_CASE("nodes on one line give a path", "[edges][delaunay]") {
  CHECK(DelaunayEdges2{}(nodes_at({{0, 0}, {30, 10}, {9, 3}, {-3, -1}})) ==
        edges({{0, 2}, {0, 3}, {1, 2}}));
}

TEST_CASE("of coincident nodes the first is triangulated and the others hang on it",
          "[edges][delaunay]") {
  CHECK(DelaunayEdges2{}(nodes_at({{5, 5}, {5, 5}, {5, 5}})) == edges({{0, 1}, {0, 2}}));
  CHECK(DelaunayEdges2{}(nodes_at({{0, 0}, {4, 0}, {0, 0}, {0, 4}, {4, 0}})) ==
        edges({{0, 1}, {0, 2}, {0, 3}, {1, 3}, {1, 4}}));
}

TEST_CASE("nodes without a pixel stay isolated", "[edges][delaunay]") {
  auto nodes = nodes_at({{0, 0}, {4, 0}, {1, 1}, {0, 4}});
  nodes[2].pixel.reset();
  CHECK(DelaunayEdges2{}(nodes) == edges({{0, 1}, {0, 3}, {1, 3}}));
}

TEST_CASE("bad coordinates are refused with the node's index", "[edges][delaunay]") {
  const auto fault_of = [](double bad) -> std::optional<CoordinateFault> {
    try {
      DelaunayEdges2{}(nodes_at({{0, 0}, {1, 0}, {2, bad}}));
    } catch (const InsertionError& error) {
      CHECK(error.index() == 2u);
      return error.fault();
    }
    return std::nullopt;
  };
  CHECK(fault_of(std::numeric_limits<double>::quiet_NaN()) == CoordinateFault::nan);
  CHECK(fault_of(-std::numeric_limits<double>::infinity()) == CoordinateFault::infinite);
  CHECK(fault_of(-0x1.1p201) == CoordinateFault::too_large);
  CHECK(fault_of(0x1p-143) == CoordinateFault::too_small);
  CHECK_FALSE(fault_of(0x1p201).has_value());
  CHECK_FALSE(fault_of(-0x1p-142).has_value());
  CHECK_FALSE(fault_of(-0.0).has_value());
}
