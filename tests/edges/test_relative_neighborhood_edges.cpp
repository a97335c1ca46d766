// SPDX-License-Identifier: MIT
#include <topobag/edges/gabriel_edges.hpp>
#include <topobag/edges/relative_neighborhood_edges.hpp>

#include "catch.hpp"
#include "edges/planar_layouts.hpp"
#include "edges/planar_truth.hpp"

using namespace topobag;
using namespace layouts;

namespace {

/// Pairs without a third point strictly closer to both than they are to each other.
EdgeList relative_neighborhood_truth(const Layout& layout) {
  return edges_where(layout, [&](std::size_t i, std::size_t j) {
    const Wide length = squared_distance(layout[i], layout[j]);
    return std::none_of(layout.begin(), layout.end(), [&](const Point& r) {
      return squared_distance(layout[i], r) < length && squared_distance(layout[j], r) < length;
    });
  });
}

}  // namespace

TEST_CASE("relative neighbourhood edges equal brute force and are Gabriel edges",
          "[edges][delaunay][relative_neighborhood]") {
  Random random(41);
  for (std::size_t round = 0; round < 8000; ++round) {
    const Layout layout = any_layout(random, round);
    const auto nodes = nodes_at(layout, static_cast<int>(uniform(random, -40, 40)));
    const EdgeList found = RelativeNeighborhoodEdges{}(nodes);
    const EdgeList gabriel = GabrielEdges{}(nodes);
    INFO("round " << round << ", " << layout.size() << " points");
    REQUIRE(found == relative_neighborhood_truth(layout));
    REQUIRE(std::includes(gabriel.begin(), gabriel.end(), found.begin(), found.end()));
  }
}

TEST_CASE("relative neighbourhoods survive long edges across many nodes",
          "[edges][delaunay][relative_neighborhood]") {
  Random random(42);
  Layout layout = scattered(random, 300, 1000);
  layout.push_back({-100000, 3});
  layout.push_back({90000, 5});
  CHECK(RelativeNeighborhoodEdges{}(nodes_at(layout)) == relative_neighborhood_truth(layout));
}
