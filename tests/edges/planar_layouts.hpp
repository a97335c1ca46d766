// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <random>
#include <tuple>
#include <utility>
#include <vector>

#include <topobag/edges/edge_list.hpp>
#include <topobag/types/semantic_node.hpp>

/// Layouts on an integer lattice, |x| <= 2^20, and what is true of them in exact arithmetic.
namespace layouts {

using namespace topobag;
using Random = std::mt19937_64;
__extension__ using Wide = __int128;

struct Point {
  std::int64_t x = 0;
  std::int64_t y = 0;
  friend bool operator==(const Point& l, const Point& r) { return l.x == r.x && l.y == r.y; }
  friend bool operator<(const Point& l, const Point& r) {
    return std::tie(l.x, l.y) < std::tie(r.x, r.y);
  }
};
using Layout = std::vector<Point>;

inline std::int64_t uniform(Random& random, std::int64_t low, std::int64_t high) {
  return std::uniform_int_distribution<std::int64_t>(low, high)(random);
}

inline Point random_point(Random& random, std::int64_t bound) {
  return {uniform(random, -bound, bound), uniform(random, -bound, bound)};
}

// ---- Layouts -----------------------------------------------------------------------------------

constexpr std::int64_t bound = std::int64_t{1} << 20;

inline Layout scattered(Random& random, std::size_t n, std::int64_t within) {
  Layout layout(n);
  for (Point& point : layout) point = random_point(random, within);
  return layout;
}

inline Layout grid(Random& random, std::size_t n) {
  const auto columns = uniform(random, 1, 8);
  const Point step{uniform(random, 1, 1000), uniform(random, 1, 1000)};
  Layout layout(n);
  for (std::size_t i = 0; i < n; ++i) {
    const auto k = static_cast<std::int64_t>(i);
    layout[i] = {k % columns * step.x, k / columns * step.y};
  }
  return layout;
}

/// Lattice points of one circle (1105 = 5 * 13 * 17 has 108 of them), at times with its centre.
inline Layout cocircular(Random& random, std::size_t n) {
  static const Layout circle = [] {
    Layout points;
    for (std::int64_t x = -1105; x <= 1105; ++x) {
      const auto y = std::llround(std::sqrt(1105.0 * 1105.0 - static_cast<double>(x * x)));
      if (x * x + y * y != 1105 * 1105) continue;
      points.push_back({x, y});
      if (y != 0) points.push_back({x, -y});
    }
    return points;
  }();
  Layout layout = circle;
  std::shuffle(layout.begin(), layout.end(), random);
  layout.resize(n);
  const Point center = random_point(random, 1000);
  for (Point& point : layout) point = {point.x + center.x, point.y + center.y};
  if (n > 0 && uniform(random, 0, 1) == 0) layout.back() = center;
  return layout;
}

inline Layout collinear(Random& random, std::size_t n) {
  const Point origin = random_point(random, 1000);
  const Point direction = random_point(random, 10);
  Layout layout(n);
  for (Point& point : layout) {
    const auto t = uniform(random, -1000, 1000);
    point = {origin.x + t * direction.x, origin.y + t * direction.y};
  }
  return layout;
}

inline Layout with_duplicates(Random& random, std::size_t n) {
  Layout layout = scattered(random, n, bound);
  for (std::size_t i = 1; i < n; i += 2) {
    layout[i] = layout[static_cast<std::size_t>(uniform(random, 0, static_cast<int>(i) - 1))];
  }
  return layout;
}

inline Layout with_near_duplicates(Random& random, std::size_t n) {
  Layout layout = scattered(random, n, bound - 1);
  for (std::size_t i = 1; i < n; i += 2) {
    const Point offset = random_point(random, 1);
    layout[i] = {layout[i - 1].x + offset.x, layout[i - 1].y + offset.y};
  }
  return layout;
}

/// A layout of up to `max_size` points, in random order; successive rounds cover every kind.
inline Layout any_layout(Random& random, std::size_t round, std::size_t max_size = 40) {
  const auto n = static_cast<std::size_t>(uniform(random, 0, static_cast<int>(max_size)));
  Layout layout;
  switch (round % 8) {
    case 0:
      layout = scattered(random, n, bound);
      break;
    case 1:
      layout = scattered(random, n, 1000);
      break;
    case 2:
      layout = scattered(random, n, 4);
      break;
    case 3:
      layout = grid(random, n);
      break;
    case 4:
      layout = cocircular(random, n);
      break;
    case 5:
      layout = collinear(random, n);
      break;
    case 6:
      layout = with_duplicates(random, n);
      break;
    default:
      layout = with_near_duplicates(random, n);
      break;
  }
  std::shuffle(layout.begin(), layout.end(), random);
  return layout;
}

inline Eigen::Vector2d scaled(const Point& point, int exponent) {
  return {std::ldexp(static_cast<double>(point.x), exponent),
          std::ldexp(static_cast<double>(point.y), exponent)};
}

/// Nodes whose pixels are the points times 2^exponent.
inline std::vector<SemanticNode<>> nodes_at(const Layout& layout, int exponent = 0) {
  std::vector<SemanticNode<>> nodes(layout.size());
  for (std::size_t i = 0; i < layout.size(); ++i) nodes[i].pixel = scaled(layout[i], exponent);
  return nodes;
}

// ---- The truth ---------------------------------------------------------------------------------

/// > 0: a, b, c turn left; 0: on one line.
inline Wide orientation(const Point& a, const Point& b, const Point& c) {
  return Wide(b.x - a.x) * (c.y - a.y) - Wide(b.y - a.y) * (c.x - a.x);
}

inline Wide squared_distance(const Point& a, const Point& b) {
  return Wide(a.x - b.x) * (a.x - b.x) + Wide(a.y - b.y) * (a.y - b.y);
}

/// > 0: d lies strictly inside the circle of a, b, c, which turn left; 0: on it.
inline Wide in_circle(const Point& a, const Point& b, const Point& c, const Point& d) {
  const Point p{a.x - d.x, a.y - d.y}, q{b.x - d.x, b.y - d.y}, r{c.x - d.x, c.y - d.y};
  const auto norm = [](const Point& v) { return Wide(v.x) * v.x + Wide(v.y) * v.y; };
  return norm(p) * (Wide(q.x) * r.y - Wide(q.y) * r.x) -
         norm(q) * (Wide(p.x) * r.y - Wide(p.y) * r.x) +
         norm(r) * (Wide(p.x) * q.y - Wide(p.y) * q.x);
}

/// For each point the first one at its position.
inline std::vector<std::size_t> first_twins(const Layout& layout) {
  std::map<Point, std::size_t> first;
  std::vector<std::size_t> twins(layout.size());
  for (std::size_t i = 0; i < layout.size(); ++i)
    twins[i] = first.emplace(layout[i], i).first->second;
  return twins;
}

/// The indices of the points that come first at their position.
inline std::vector<std::size_t> distinct(const Layout& layout) {
  const auto twins = first_twins(layout);
  std::vector<std::size_t> indices;
  for (std::size_t i = 0; i < layout.size(); ++i) {
    if (twins[i] == i) indices.push_back(i);
  }
  return indices;
}

/// One edge from each later coincident point to the first.
inline EdgeList twin_edges(const Layout& layout) {
  const auto twins = first_twins(layout);
  EdgeList edges;
  for (std::size_t i = 0; i < layout.size(); ++i) {
    if (twins[i] != i) edges.push_back({node_index(twins[i]), node_index(i)});
  }
  return edges;
}

/// Joins those distinct points whose pair `keep(i, j)` accepts, and coincident ones to their first.
template <typename Keep>
EdgeList edges_where(const Layout& layout, Keep keep) {
  EdgeList edges = twin_edges(layout);
  const auto indices = distinct(layout);
  for (const std::size_t i : indices) {
    for (const std::size_t j : indices) {
      if (i < j && keep(i, j)) edges.push_back({node_index(i), node_index(j)});
    }
  }
  make_canonical(edges);
  return edges;
}

/// Every edge of every triangle whose circle has nothing strictly inside; on one line, the path.
struct DelaunayTruth {
  EdgeList edges;        ///< with the edges to coincident points
  bool unique = true;    ///< no such circle passes through a fourth point: general position
  bool on_line = true;   ///< no triangle at all
  std::size_t hull = 0;  ///< number of points on the boundary of the hull
};

inline DelaunayTruth delaunay_truth(const Layout& layout) {
  DelaunayTruth truth;
  truth.edges = twin_edges(layout);
  const auto indices = distinct(layout);
  const auto add = [&](std::size_t i, std::size_t j) {
    truth.edges.push_back(make_edge(node_index(i), node_index(j)));
  };
  std::vector<bool> on_hull(layout.size(), false);
  for (const std::size_t i : indices) {
    for (const std::size_t j : indices) {
      if (i == j) continue;
      const bool all_left = std::all_of(indices.begin(), indices.end(), [&](std::size_t k) {
        return orientation(layout[i], layout[j], layout[k]) >= 0;
      });
      if (all_left) on_hull[i] = on_hull[j] = true;
      for (const std::size_t k : indices) {
        if (i > j || i > k || orientation(layout[i], layout[j], layout[k]) <= 0) continue;
        truth.on_line = false;
        bool empty = true, unique = true;
        for (auto l = indices.begin(); empty && l != indices.end(); ++l) {
          if (*l == i || *l == j || *l == k) continue;
          const Wide side = in_circle(layout[i], layout[j], layout[k], layout[*l]);
          if (side > 0) empty = false;
          if (side == 0) unique = false;
        }
        if (!empty) continue;
        truth.unique = truth.unique && unique;
        add(i, j);
        add(j, k);
        add(k, i);
      }
    }
  }
  truth.hull = static_cast<std::size_t>(std::count(on_hull.begin(), on_hull.end(), true));
  if (truth.on_line) {
    auto along = indices;
    std::sort(along.begin(), along.end(),
              [&](std::size_t l, std::size_t r) { return layout[l] < layout[r]; });
    for (std::size_t i = 1; i < along.size(); ++i) add(along[i - 1], along[i]);
  }
  make_canonical(truth.edges);
  return truth;
}

// ---- Relabelling -------------------------------------------------------------------------------

/// The edges with node i called `name[i]`.
inline EdgeList renamed(const EdgeList& edges, const std::vector<std::size_t>& name) {
  EdgeList result;
  for (const Edge& edge : edges) {
    result.push_back(make_edge(node_index(name[value(edge.a)]), node_index(name[value(edge.b)])));
  }
  make_canonical(result);
  return result;
}

/// `layout` without repetitions.
inline Layout without_duplicates(const Layout& layout) {
  Layout result;
  for (const std::size_t i : distinct(layout)) result.push_back(layout[i]);
  return result;
}

}  // namespace layouts
