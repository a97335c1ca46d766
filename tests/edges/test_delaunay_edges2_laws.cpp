// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <numeric>
#include <vector>

#include <topobag/edges/delaunay_edges2.hpp>

#include "catch.hpp"
#include "edges/planar_layouts.hpp"
#include "edges/planar_truth.hpp"

using namespace topobag;
using namespace layouts;

TEST_CASE("unique: every order of the nodes gives one edge set", "[edges][delaunay][paper]") {
  Random random(2);
  for (std::size_t round = 0; round < 10000; ++round) {
    const Layout layout = without_duplicates(any_layout(random, round));
    const EdgeList expected = DelaunayEdges2{}(nodes_at(layout));
    std::vector<std::size_t> order(layout.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    for (int repetition = 0; repetition < 3; ++repetition) {
      std::shuffle(order.begin(), order.end(), random);
      Layout shuffled;
      for (const std::size_t i : order) shuffled.push_back(layout[i]);
      INFO("round " << round);
      REQUIRE(renamed(DelaunayEdges2{}(nodes_at(shuffled)), order) == expected);
    }
  }
}

TEST_CASE("unique: all orders of small cocircular layouts, and large grids",
          "[edges][delaunay][paper]") {
  const auto check = [](const Layout& layout, std::vector<std::size_t> order) {
    const EdgeList expected = DelaunayEdges2{}(nodes_at(layout));
    do {
      Layout permuted;
      for (const std::size_t i : order) permuted.push_back(layout[i]);
      REQUIRE(renamed(DelaunayEdges2{}(nodes_at(permuted)), order) == expected);
    } while (std::next_permutation(order.begin(), order.end()));
  };
  check({{0, 0}, {1, 0}, {0, 1}, {1, 1}}, {0, 1, 2, 3});
  check({{0, 0}, {1, 0}, {2, 0}, {0, 1}, {1, 1}, {2, 1}}, {0, 1, 2, 3, 4, 5});
  check({{5, 0}, {4, 3}, {3, 4}, {0, 5}, {-3, 4}, {-4, -3}, {3, -4}}, {0, 1, 2, 3, 4, 5, 6});

  Random random(3);  // large enough for the spatial sort
  Layout grid;
  for (std::int64_t x = 0; x < 40; ++x) {
    for (std::int64_t y = 0; y < 30; ++y) grid.push_back({x, y});
  }
  const EdgeList expected = DelaunayEdges2{}(nodes_at(grid));
  CHECK(expected.size() == 3 * grid.size() - 3 - 136);
  std::vector<std::size_t> order(grid.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (int repetition = 0; repetition < 20; ++repetition) {
    std::shuffle(order.begin(), order.end(), random);
    Layout shuffled;
    for (const std::size_t i : order) shuffled.push_back(grid[i]);
    REQUIRE(renamed(DelaunayEdges2{}(nodes_at(shuffled)), order) == expected);
  }
}

TEST_CASE("of coincident nodes the first wins in large layouts too", "[edges][delaunay]") {
  Random random(4);
  Layout layout = with_duplicates(random, 1000);
  std::shuffle(layout.begin(), layout.end(), random);
  const auto indices = distinct(layout);
  EdgeList expected = renamed(DelaunayEdges2{}(nodes_at(without_duplicates(layout))), indices);
  const EdgeList twins = twin_edges(layout);
  expected.insert(expected.end(), twins.begin(), twins.end());
  make_canonical(expected);
  CHECK(DelaunayEdges2{}(nodes_at(layout)) == expected);
}

TEST_CASE("regional: a node that comes or goes changes only edges between its neighbours",
          "[edges][delaunay][paper]") {
  Random random(5);
  for (std::size_t round = 0; round < 10000; ++round) {
    const Layout with = any_layout(random, round);
    if (with.empty()) continue;
    const auto p = static_cast<std::size_t>(uniform(random, 0, static_cast<int>(with.size()) - 1));
    Layout without = with;
    without.erase(without.begin() + static_cast<std::ptrdiff_t>(p));
    std::vector<std::size_t> name(without.size());  // as called in `with`
    for (std::size_t i = 0; i < name.size(); ++i) name[i] = i < p ? i : i + 1;

    const EdgeList after = DelaunayEdges2{}(nodes_at(with));
    const EdgeList before = renamed(DelaunayEdges2{}(nodes_at(without)), name);
    std::vector<bool> near(with.size(), false);
    for (const Edge& edge : after) {
      if (value(edge.a) == p) near[value(edge.b)] = true;
      if (value(edge.b) == p) near[value(edge.a)] = true;
    }
    EdgeList changed;
    std::set_symmetric_difference(before.begin(), before.end(), after.begin(), after.end(),
                                  std::back_inserter(changed));
    for (const Edge& edge : changed) {
      INFO("round " << round << ", edge " << value(edge.a) << "-" << value(edge.b));
      REQUIRE(((value(edge.a) == p || near[value(edge.a)]) &&
               (value(edge.b) == p || near[value(edge.b)])));
    }
  }
}

TEST_CASE("a quarter turn keeps the edges in general position, and may turn a grid's diagonals",
          "[edges][delaunay]") {
  const auto turned = [](Layout layout) {
    for (Point& point : layout) point = {-point.y, point.x};
    return layout;
  };
  Random random(6);
  for (std::size_t round = 0; round < 500; ++round) {
    const Layout layout = any_layout(random, round);
    const EdgeList upright = DelaunayEdges2{}(nodes_at(layout));
    const EdgeList lying = DelaunayEdges2{}(nodes_at(turned(layout)));
    REQUIRE(upright.size() == lying.size());
    if (delaunay_truth(layout).unique) REQUIRE(upright == lying);
  }
  const Layout square = {{0, 0}, {1, 0}, {0, 1}, {1, 1}};
  CHECK(DelaunayEdges2{}(nodes_at(square)) != DelaunayEdges2{}(nodes_at(turned(square))));
}
