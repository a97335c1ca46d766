// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <set>

#include <topobag/edges/delaunay_edges2.hpp>
#include <topobag/edges/delaunay_edges3.hpp>

#include "catch.hpp"
#include "edges/planar_layouts.hpp"
#include "edges/planar_truth.hpp"

using namespace topobag;
using layouts::Random;
using layouts::uniform;
using layouts::Wide;

namespace {

using Point = std::array<std::int64_t, 3>;
using Layout = std::vector<Point>;

std::vector<SemanticNode<>> nodes_at(const Layout& layout, int exponent = 0) {
  std::vector<SemanticNode<>> nodes(layout.size());
  for (std::size_t i = 0; i < layout.size(); ++i) {
    Eigen::Vector3d& place = nodes[i].position.emplace();
    for (std::size_t k = 0; k < 3; ++k) {
      place[static_cast<Eigen::Index>(k)] = std::ldexp(static_cast<double>(layout[i][k]), exponent);
    }
  }
  return nodes;
}

Wide det3(const Point& a, const Point& b, const Point& c) {
  return Wide(a[0]) * (Wide(b[1]) * c[2] - Wide(b[2]) * c[1]) -
         Wide(a[1]) * (Wide(b[0]) * c[2] - Wide(b[2]) * c[0]) +
         Wide(a[2]) * (Wide(b[0]) * c[1] - Wide(b[1]) * c[0]);
}

Point minus(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

Wide orientation(const Point& a, const Point& b, const Point& c, const Point& d) {
  return det3(minus(a, d), minus(b, d), minus(c, d));
}

/// > 0: e lies strictly inside the sphere of a, b, c, d; 0: on it.
Wide in_sphere(const Point& a, const Point& b, const Point& c, const Point& d, const Point& e) {
  const Point p = minus(a, e), q = minus(b, e), r = minus(c, e), s = minus(d, e);
  const auto norm = [](const Point& v) {
    return Wide(v[0]) * v[0] + Wide(v[1]) * v[1] + Wide(v[2]) * v[2];
  };
  const Wide lifted = norm(p) * det3(q, r, s) - norm(q) * det3(p, r, s) + norm(r) * det3(p, q, s) -
                      norm(s) * det3(p, q, r);
  return orientation(a, b, c, d) > 0 ? -lifted : lifted;
}

/// The edges of all tetrahedra with nothing strictly inside their sphere; `unique` if none of these
/// spheres passes through a fifth point.
EdgeList delaunay_truth(const Layout& layout, bool& unique) {
  EdgeList edges;
  unique = true;
  const std::size_t n = layout.size();
  for (std::size_t a = 0; a < n; ++a) {
    for (std::size_t b = a + 1; b < n; ++b) {
      for (std::size_t c = b + 1; c < n; ++c) {
        for (std::size_t d = c + 1; d < n; ++d) {
          if (orientation(layout[a], layout[b], layout[c], layout[d]) == 0) continue;
          bool empty = true, alone = true;
          for (std::size_t e = 0; empty && e < n; ++e) {
            if (e == a || e == b || e == c || e == d) continue;
            const Wide side = in_sphere(layout[a], layout[b], layout[c], layout[d], layout[e]);
            if (side > 0) empty = false;
            if (side == 0) alone = false;
          }
          if (!empty) continue;
          unique = unique && alone;
          const std::size_t corners[] = {a, b, c, d};
          for (const std::size_t i : corners) {
            for (const std::size_t j : corners) {
              if (i < j) edges.push_back({node_index(i), node_index(j)});
            }
          }
        }
      }
    }
  }
  make_canonical(edges);
  return edges;
}

Layout scattered(Random& random, std::size_t n, std::int64_t bound) {
  std::set<Point> points;
  while (points.size() < n) {
    points.insert({uniform(random, -bound, bound), uniform(random, -bound, bound),
                   uniform(random, -bound, bound)});
  }
  Layout layout(points.begin(), points.end());
  std::shuffle(layout.begin(), layout.end(), random);
  return layout;
}

Layout any_layout(Random& random, std::size_t round) {
  const auto n = static_cast<std::size_t>(uniform(random, 0, 14));
  return scattered(random, n, std::array<std::int64_t, 4>{1 << 18, 100, 4, 1}[round % 4]);
}

}  // namespace

TEST_CASE("spatial Delaunay edges equal brute force", "[edges][delaunay]") {
  Random random(21);
  std::size_t unique_layouts = 0;
  for (std::size_t round = 0; round < 2000; ++round) {
    const Layout layout = any_layout(random, round);
    bool unique = true;
    const EdgeList expected = delaunay_truth(layout, unique);
    const EdgeList found =
        DelaunayEdges3{}(nodes_at(layout, static_cast<int>(uniform(random, -40, 40))));
    INFO("round " << round << ", " << layout.size() << " points");
    REQUIRE(std::is_sorted(found.begin(), found.end()));
    if (expected.empty()) continue;  // all in one plane
    if (unique) REQUIRE(found == expected);
    REQUIRE(std::includes(expected.begin(), expected.end(), found.begin(), found.end()));
    unique_layouts += unique;
  }
  CHECK(unique_layouts > 700);
}

TEST_CASE("unique in space: every order gives one edge set, cospherical grids included",
          "[edges][delaunay]") {
  Random random(22);
  for (std::size_t round = 0; round < 1000; ++round) {
    const Layout layout = any_layout(random, round);
    const EdgeList expected = DelaunayEdges3{}(nodes_at(layout));
    std::vector<std::size_t> order(layout.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::shuffle(order.begin(), order.end(), random);
    Layout shuffled;
    for (const std::size_t i : order) shuffled.push_back(layout[i]);
    REQUIRE(layouts::renamed(DelaunayEdges3{}(nodes_at(shuffled)), order) == expected);
  }
}

TEST_CASE("nodes in one plane get its planar edges", "[edges][delaunay]") {
  Random random(23);
  for (std::size_t round = 0; round < 500; ++round) {
    const layouts::Layout plan = layouts::any_layout(random, round);
    auto nodes = layouts::nodes_at(plan);
    for (auto& node : nodes) node.position = Eigen::Vector3d(node.pixel->x(), node.pixel->y(), 5.0);
    const EdgeList found = DelaunayEdges3{}(nodes);
    const EdgeList planar = DelaunayEdges2{}(nodes);
    REQUIRE(found.size() == planar.size());
    if (layouts::delaunay_truth(plan).unique) REQUIRE(found == planar);
  }
}

TEST_CASE("degenerate nodes in space", "[edges][delaunay]") {
  const auto edge = [](std::size_t a, std::size_t b) { return Edge{node_index(a), node_index(b)}; };
  const DelaunayEdges3 build;
  CHECK(build(nodes_at({})).empty());
  CHECK(build(nodes_at({{1, 2, 3}})).empty());
  CHECK(build(nodes_at({{1, 2, 3}, {4, 5, 6}})) == EdgeList{edge(0, 1)});
  CHECK(build(nodes_at({{0, 0, 0}, {6, 6, 6}, {1, 1, 1}})) == EdgeList{edge(0, 2), edge(1, 2)});
  CHECK(build(nodes_at({{7, 7, 7}, {7, 7, 7}, {7, 7, 7}})) == EdgeList{edge(0, 1), edge(0, 2)});

  auto nodes = nodes_at({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 1}});
  CHECK(build(nodes).size() == 7);
  nodes[1].position.reset();
  CHECK(build(nodes) == EdgeList{edge(0, 2), edge(0, 3), edge(2, 3), edge(3, 4)});
  nodes[2].position->z() = std::numeric_limits<double>::quiet_NaN();
  try {
    build(nodes);
    FAIL("accepted a coordinate that is not a number");
  } catch (const InsertionError& error) {
    CHECK(error.index() == 2u);
    CHECK(error.fault() == CoordinateFault::nan);
  }
}

TEST_CASE("spatial edges do not depend on the camera's place in general position",
          "[edges][delaunay]") {
  Random random(24);
  const Eigen::Isometry3d T_b_a = Eigen::Translation3d(3, -4, 5) *
                                  Eigen::AngleAxisd(1.1, Eigen::Vector3d(2, -1, 3).normalized());
  for (int round = 0; round < 100; ++round) {
    auto nodes = nodes_at(scattered(random, 30, 1000));
    const EdgeList expected = DelaunayEdges3{}(nodes);
    for (auto& node : nodes) node.position = T_b_a * *node.position;
    REQUIRE(DelaunayEdges3{}(nodes) == expected);
  }
}

TEST_CASE("large sets in space: of coincident nodes the first wins", "[edges][delaunay]") {
  Random random(25);
  Layout layout = scattered(random, 400, 1000);
  const EdgeList single = DelaunayEdges3{}(nodes_at(layout));
  const std::size_t n = layout.size();
  layout.insert(layout.end(), layout.begin(), layout.begin() + 100);
  EdgeList expected = single;
  for (std::size_t i = 0; i < 100; ++i) expected.push_back({node_index(i), node_index(n + i)});
  make_canonical(expected);
  CHECK(DelaunayEdges3{}(nodes_at(layout)) == expected);
}
