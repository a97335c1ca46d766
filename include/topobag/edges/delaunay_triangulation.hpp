// SPDX-License-Identifier: MIT
#pragma once

// Includes CGAL's triangulations, which are GPL-3.0-or-later or under a commercial licence.

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <Eigen/Core>

#include <topobag/edges/detail/delaunay_hinted.hpp>
#include <topobag/edges/edge_list.hpp>
#include <topobag/edges/hints.hpp>
#include <topobag/edges/insertion_error.hpp>
#include <topobag/edges/position_in_triangulation.hpp>
#include <topobag/error.hpp>
#include <topobag/types/position_traits.hpp>

namespace topobag {
inline namespace v0 {

/// An input that `bulk_load` left out, since an earlier one has the same position.
struct CoincidentInput {
  NodeIndex lost{};  ///< the input left out; its index is free
  NodeIndex kept{};  ///< the first input at that position
};

/// A planar Delaunay triangulation that grows and shrinks, over any vertex type that has
/// `PositionTraits`. Exact: what it answers is true of the coordinates, not of rounded ones.
///
/// Vertices are known by their index. An index stays the vertex's until that vertex is removed;
/// free indices are used again, the one freed last first. All results are in canonical order and do
/// not depend on the order of insertion, on removed vertices, or on the hint.
///
/// `Hint` decides where a search starts: `LastUsedVertexHint`, `HierarchyHint`, or a user's own.
///
/// Positions must be as `validate_position` asks, else `InsertionError` is thrown; an index without
/// a vertex throws `InvalidId`. A call that throws has changed nothing. Any number of threads may
/// call const members at once. Copies share nothing; a moved-from triangulation is empty.
///
/// For the edges of one set of nodes `DelaunayEdges2` is simpler and does less.
template <typename Vertex, typename Hint = LastUsedVertexHint>
class DelaunayTriangulation {
  static_assert(has_position_v<Vertex>,
                "topobag: a vertex needs a position: specialise topobag::PositionTraits<Vertex> "
                "with static Eigen::Vector2d position(const Vertex&).");
  static_assert(is_hint_v<Hint>,
                "topobag: a hint has suggest(const Eigen::Vector2d&) const -> "
                "std::optional<NodeIndex> and notice(NodeIndex) const, and can be copied.");

 public:
  DelaunayTriangulation() = default;
  DelaunayTriangulation(const DelaunayTriangulation& other)
      : triangulation_(other.triangulation_),
        vertices_(other.vertices_),
        free_(other.free_),
        hint_(other.hint_) {
    link_handles();
  }
  DelaunayTriangulation(DelaunayTriangulation&& other) : DelaunayTriangulation() { swap(other); }
  DelaunayTriangulation& operator=(DelaunayTriangulation other) {
    swap(other);
    return *this;
  }

  /// O(1).
  void swap(DelaunayTriangulation& other) {
    triangulation_.swap(other.triangulation_);
    vertices_.swap(other.vertices_);
    handles_.swap(other.handles_);
    free_.swap(other.free_);
    std::swap(hint_, other.hint_);
  }

  // ---- Changing it
  // -------------------------------------------------------------------------------

  /// Replaces the content: index i is the i-th input. Of coincident inputs the first stays; the
  /// others are left out and returned, ordered by index. O(n log n).
  std::vector<CoincidentInput> bulk_load(std::vector<Vertex> vertices);

  /// Adds a vertex. If one is at that position already, the new one takes its place and its index.
  /// O(1) from a good hint, plus the number of new edges.
  NodeIndex insert(Vertex vertex) {
    const Point point = point_of(vertex);
    return insert_at(std::move(vertex), point, start_near(point));
  }

  /// As above; the search starts from the vertex `hint`.
  NodeIndex insert(Vertex vertex, NodeIndex hint) {
    const FaceHandle start = handle(hint)->face();
    const Point point = point_of(vertex);
    return insert_at(std::move(vertex), point, start);
  }

  /// Takes a vertex out and returns it. No other index changes. O(d²), d its number of neighbours.
  Vertex remove(NodeIndex index) {
    const VertexHandle gone = handle(index);
    free_.reserve(free_.size() + 1);
    Vertex vertex = std::move(*vertices_[value(index)]);
    free_.push_back(index);
    vertices_[value(index)].reset();
    handles_[value(index)] = VertexHandle();
    triangulation_.remove(gone);
    return vertex;
  }

  /// Takes all vertices out; every index is free.
  void clear() {
    triangulation_.clear();
    vertices_.clear();
    handles_.clear();
    free_.clear();
  }

  /// Makes room for the payload of this many vertices.
  void reserve(std::size_t num_vertices) {
    vertices_.reserve(num_vertices);
    handles_.reserve(num_vertices);
  }

  // ---- What is in it
  // -----------------------------------------------------------------------------

  std::size_t size() const noexcept { return triangulation_.number_of_vertices(); }
  bool empty() const noexcept { return size() == 0; }

  /// Whether the index is that of a vertex.
  bool contains(NodeIndex index) const noexcept {
    return value(index) < handles_.size() && handles_[value(index)] != VertexHandle();
  }

  /// The vertex as it was inserted.
  const Vertex& vertex(NodeIndex index) const {
    handle(index);
    return *vertices_[value(index)];
  }

  /// Where the vertex lies.
  Eigen::Vector2d position(NodeIndex index) const {
    const Point& point = handle(index)->point();
    return {point.x(), point.y()};
  }

  /// The indices of all vertices, ascending. O(n).
  std::vector<NodeIndex> vertices() const;

  /// All edges, in canonical order. O(n).
  EdgeList undirected_edges() const;

  /// Each edge in both directions, ordered by start, then end. O(n log n).
  std::vector<DirectedEdge> directed_edges() const;

  /// The triangles, sorted; none when all vertices lie on one line. O(n log n).
  std::vector<Triangle> inner_faces() const;

  /// The vertices on the boundary of the convex hull, those inside its edges included,
  /// counterclockwise (x right, y up) from the smallest index on. Vertices on one line: in their
  /// order along it, from the end with the smaller index. O(h).
  std::vector<NodeIndex> convex_hull() const;

  /// The vertices that share an edge with this one, counterclockwise from the smallest index on.
  std::vector<NodeIndex> neighbors(NodeIndex index) const;

  /// Checks every structure and every circumcircle; for tests. O(n).
  bool is_valid() const;

  // ---- Asking about a position
  // -------------------------------------------------------------------

  /// What lies at `position`. O(1) from a good hint.
  PositionInTriangulation locate(const Eigen::Vector2d& position) const;

  /// The vertex exactly at `position`, if there is one.
  std::optional<NodeIndex> locate_vertex(const Eigen::Vector2d& position) const {
    const PositionInTriangulation place = locate(position);
    const OnVertex* found = std::get_if<OnVertex>(&place);
    return found ? std::optional(found->vertex) : std::nullopt;
  }

  /// The vertex closest to `position`, of equally close ones the smallest index; empty when there
  /// is no vertex. O(1) from a good hint; O(n) when all vertices lie on one line.
  std::optional<NodeIndex> nearest_neighbor(const Eigen::Vector2d& position) const;

 private:
  using Triangulation = detail::HintedDelaunay<Hint>;
  using Point = detail::Kernel::Point_2;
  using VertexHandle = typename Triangulation::Vertex_handle;
  using FaceHandle = typename Triangulation::Face_handle;

  static Point checked_point(const Eigen::Vector2d& position,
                             std::optional<std::size_t> index = std::nullopt) {
    validate_position(position, index);
    return {position.x(), position.y()};
  }
  static Point point_of(const Vertex& vertex, std::optional<std::size_t> index = std::nullopt) {
    return checked_point(PositionTraits<Vertex>::position(vertex), index);
  }

  VertexHandle handle(NodeIndex index) const {
    if (contains(index)) return handles_[value(index)];
    throw InvalidId("The triangulation has no vertex " + std::to_string(value(index)) +
                        ": it was removed, lost to an earlier coincident one, or never inserted.",
                    value(index));
  }

  /// A face close to the point as far as the hint knows; null leaves the choice to CGAL.
  FaceHandle start_near(const Point& point) const {
    const std::optional<NodeIndex> near = hint_.suggest(Eigen::Vector2d(point.x(), point.y()));
    return near && contains(*near) ? handles_[value(*near)]->face() : FaceHandle();
  }

  NodeIndex insert_at(Vertex vertex, const Point& point, FaceHandle start);
  void link_handles();
  VertexHandle closest_to(const Point& point) const;

  static bool is_closer(const Point& point, VertexHandle a, VertexHandle b) {
    return CGAL::compare_distance_to_point(point, a->point(), b->point()) == CGAL::SMALLER;
  }

  Triangulation triangulation_;
  std::vector<std::optional<Vertex>> vertices_;  ///< by index; empty where the index is free
  std::vector<VertexHandle> handles_;            ///< by index; null where the index is free
  std::vector<NodeIndex> free_;                  ///< free indices, the next to be used last
  Hint hint_;
};

}  // namespace v0
}  // namespace topobag

#include <topobag/edges/detail/delaunay_triangulation_impl.hpp>
