// SPDX-License-Identifier: MIT
#include <topobag/edges/delaunay_edges2.hpp>
#include <topobag/edges/gabriel_edges.hpp>

#include "catch.hpp"
#include "edges/planar_layouts.hpp"
#include "edges/planar_truth.hpp"

using namespace topobag;
using namespace layouts;

namespace {

/// Pairs whose closed disc holds no third point.
EdgeList gabriel_truth(const Layout& layout) {
  return edges_where(layout, [&](std::size_t i, std::size_t j) {
    const Point p = layout[i], q = layout[j];
    return std::none_of(layout.begin(), layout.end(), [&](const Point& r) {
      if (r == p || r == q) return false;
      return Wide(p.x - r.x) * (q.x - r.x) + Wide(p.y - r.y) * (q.y - r.y) <= 0;
    });
  });
}

}  // namespace

TEST_CASE("Gabriel edges equal brute force and are Delaunay edges", "[edges][delaunay][gabriel]") {
  Random random(31);
  for (std::size_t round = 0; round < 8000; ++round) {
    const Layout layout = any_layout(random, round);
    const auto nodes = nodes_at(layout, static_cast<int>(uniform(random, -40, 40)));
    const EdgeList found = GabrielEdges{}(nodes);
    const EdgeList delaunay = DelaunayEdges2{}(nodes);
    INFO("round " << round << ", " << layout.size() << " points");
    REQUIRE(found == gabriel_truth(layout));
    REQUIRE(std::includes(delaunay.begin(), delaunay.end(), found.begin(), found.end()));
  }
}

TEST_CASE("a grid has no Gabriel diagonals", "[edges][delaunay][gabriel]") {
  CHECK(GabrielEdges{}(nodes_at({{0, 0}, {1, 0}, {0, 1}, {1, 1}})).size() == 4);
}
