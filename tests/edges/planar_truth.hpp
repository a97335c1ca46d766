// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <map>
#include <vector>

#include <topobag/edges/edge_list.hpp>

#include "edges/planar_layouts.hpp"

/// What is true of the layouts in exact arithmetic.
namespace layouts {

__extension__ using Wide = __int128;

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
