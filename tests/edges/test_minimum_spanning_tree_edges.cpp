// SPDX-License-Identifier: MIT
#include <numeric>

#include <topobag/edges/minimum_spanning_tree_edges.hpp>
#include <topobag/edges/relative_neighborhood_edges.hpp>

#include "catch.hpp"
#include "edges/planar_layouts.hpp"
#include "edges/planar_truth.hpp"

using namespace topobag;
using namespace layouts;

namespace {

/// Kruskal's rule over all pairs, by length, then canonical order.
EdgeList minimum_spanning_tree_truth(const Layout& layout) {
  EdgeList pairs = edges_where(layout, [](std::size_t, std::size_t) { return true; });
  const auto length = [&](const Edge& edge) {
    return squared_distance(layout[value(edge.a)], layout[value(edge.b)]);
  };
  std::stable_sort(pairs.begin(), pairs.end(),
                   [&](const Edge& l, const Edge& r) { return length(l) < length(r); });
  std::vector<std::size_t> tree(layout.size());
  std::iota(tree.begin(), tree.end(), std::size_t{0});
  EdgeList edges;
  for (const Edge& edge : pairs) {
    const std::size_t from = tree[value(edge.a)], to = tree[value(edge.b)];
    if (from == to) continue;
    std::replace(tree.begin(), tree.end(), from, to);
    edges.push_back(edge);
  }
  make_canonical(edges);
  return edges;
}

}  // namespace

TEST_CASE("the minimum spanning tree equals brute force and lies in the relative neighbourhood",
          "[edges][delaunay][minimum_spanning_tree]") {
  Random random(51);
  for (std::size_t round = 0; round < 8000; ++round) {
    const Layout layout = any_layout(random, round);
    const auto nodes = nodes_at(layout, static_cast<int>(uniform(random, -40, 40)));
    const EdgeList found = MinimumSpanningTreeEdges{}(nodes);
    const EdgeList superset = RelativeNeighborhoodEdges{}(nodes);
    INFO("round " << round << ", " << layout.size() << " points");
    REQUIRE(found == minimum_spanning_tree_truth(layout));
    REQUIRE(found.size() == (layout.empty() ? 0 : layout.size() - 1));
    REQUIRE(std::includes(superset.begin(), superset.end(), found.begin(), found.end()));
  }
}

TEST_CASE("nodes without a pixel are no part of the tree",
          "[edges][delaunay][minimum_spanning_tree]") {
  auto nodes = nodes_at({{0, 0}, {1, 0}, {2, 0}});
  nodes[1].pixel.reset();
  CHECK(MinimumSpanningTreeEdges{}(nodes) == EdgeList{{node_index(0), node_index(2)}});
}
