// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <tuple>
#include <vector>

#include <topobag/types/semantic_node.hpp>

/// Layouts on an integer lattice, |x| <= 2^20.
namespace layouts {

using namespace topobag;
using Random = std::mt19937_64;

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

}  // namespace layouts
