// SPDX-License-Identifier: MIT
#pragma once

#include <tuple>
#include <variant>

#include <topobag/edges/edge_list.hpp>
#include <topobag/types/ids.hpp>

namespace topobag {
inline namespace v0 {

/// An edge with a direction.
struct DirectedEdge {
  NodeIndex from{};  ///< where it starts
  NodeIndex to{};    ///< where it ends

  /// The same edge the other way.
  DirectedEdge reversed() const noexcept { return {to, from}; }

  friend bool operator==(const DirectedEdge& l, const DirectedEdge& r) noexcept {
    return l.from == r.from && l.to == r.to;
  }
  friend bool operator!=(const DirectedEdge& l, const DirectedEdge& r) noexcept {
    return !(l == r);
  }
  friend bool operator<(const DirectedEdge& l, const DirectedEdge& r) noexcept {
    return std::tie(l.from, l.to) < std::tie(r.from, r.to);
  }
};

/// A triangle in canonical form: from the smallest index on, counterclockwise where x points right
/// and y up (so clockwise on a screen, where v points down).
struct Triangle {
  NodeIndex a{};  ///< the smallest index
  NodeIndex b{};  ///< the next one counterclockwise
  NodeIndex c{};  ///< the last one

  friend bool operator==(const Triangle& l, const Triangle& r) noexcept {
    return l.a == r.a && l.b == r.b && l.c == r.c;
  }
  friend bool operator!=(const Triangle& l, const Triangle& r) noexcept { return !(l == r); }
  friend bool operator<(const Triangle& l, const Triangle& r) noexcept {
    return std::tie(l.a, l.b, l.c) < std::tie(r.a, r.b, r.c);
  }
};

/// The triangle of three different vertices given counterclockwise, in canonical form.
inline Triangle make_triangle(NodeIndex a, NodeIndex b, NodeIndex c) noexcept {
  if (a < b && a < c) return {a, b, c};
  if (b < c) return {b, c, a};
  return {c, a, b};
}

/// The queried position is that of a vertex.
struct OnVertex {
  NodeIndex vertex{};  ///< that vertex
};
/// The queried position lies inside an edge.
struct OnEdge {
  Edge edge;  ///< that edge
};
/// The queried position lies inside a triangle.
struct InFace {
  Triangle face;  ///< that triangle
};
/// The queried position lies outside the convex hull of two or more vertices, or off their line.
struct OutsideOfConvexHull {};
/// There are fewer than two vertices, and none at the queried position.
struct NoTriangulation {};

/// What `DelaunayTriangulation::locate` finds: one of five, always.
using PositionInTriangulation =
    std::variant<OnVertex, OnEdge, InFace, OutsideOfConvexHull, NoTriangulation>;

}  // namespace v0
}  // namespace topobag
