// SPDX-License-Identifier: MIT
#pragma once

// The longer members of DelaunayTriangulation. Includes CGAL's triangulations, which are
// GPL-3.0-or-later or under a commercial licence.

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include <topobag/edges/delaunay_triangulation.hpp>
#include <topobag/edges/detail/bucket_sort.hpp>

namespace topobag {
inline namespace v0 {

template <typename Vertex, typename Hint>
std::vector<CoincidentInput> DelaunayTriangulation<Vertex, Hint>::bulk_load(
    std::vector<Vertex> vertices) {
  std::vector<detail::IndexedPoint<Point>> points;
  points.reserve(vertices.size());
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    points.emplace_back(point_of(vertices[i], i), node_index(i));
  }
  DelaunayTriangulation loaded;
  loaded.hint_ = hint_;
  const EdgeList twins = detail::insert_points(loaded.triangulation_, points);
  loaded.vertices_.reserve(vertices.size());
  for (Vertex& vertex : vertices) loaded.vertices_.emplace_back(std::move(vertex));

  std::vector<CoincidentInput> lost;
  for (const Edge& twin : twins) lost.push_back({twin.b, twin.a});
  std::sort(lost.begin(), lost.end(), [](auto& l, auto& r) { return l.lost < r.lost; });
  for (auto it = lost.rbegin(); it != lost.rend(); ++it) {
    loaded.vertices_[value(it->lost)].reset();
    loaded.free_.push_back(it->lost);
  }
  loaded.link_handles();
  swap(loaded);
  return lost;
}

template <typename Vertex, typename Hint>
NodeIndex DelaunayTriangulation<Vertex, Hint>::insert_at(Vertex vertex, const Point& point,
                                                         FaceHandle start) {
  if (free_.empty()) {  // before the triangulation changes: this may throw, and be tried again
    const NodeIndex fresh = node_index(vertices_.size());
    free_.reserve(1);
    handles_.resize(vertices_.size() + 1);
    vertices_.emplace_back();
    free_.push_back(fresh);
  }
  const std::size_t known = size();
  const VertexHandle inserted = triangulation_.insert(point, start);
  if (size() > known) {
    inserted->info() = free_.back();
    handles_[value(free_.back())] = inserted;
    free_.pop_back();
  }
  const NodeIndex index = inserted->info();
  vertices_[value(index)] = std::move(vertex);
  hint_.notice(index);
  return index;
}

template <typename Vertex, typename Hint>
void DelaunayTriangulation<Vertex, Hint>::link_handles() {
  handles_.assign(vertices_.size(), VertexHandle());
  for (const VertexHandle vertex : triangulation_.finite_vertex_handles()) {
    handles_[value(vertex->info())] = vertex;
  }
}

template <typename Vertex, typename Hint>
std::vector<NodeIndex> DelaunayTriangulation<Vertex, Hint>::vertices() const {
  std::vector<NodeIndex> indices;
  indices.reserve(size());
  for (std::size_t i = 0; i < handles_.size(); ++i) {
    if (contains(node_index(i))) indices.push_back(node_index(i));
  }
  return indices;
}

template <typename Vertex, typename Hint>
EdgeList DelaunayTriangulation<Vertex, Hint>::undirected_edges() const {
  EdgeList edges;
  detail::append_edges(triangulation_, edges);
  detail::bucket_sort(edges, handles_.size());
  return edges;
}

template <typename Vertex, typename Hint>
std::vector<DirectedEdge> DelaunayTriangulation<Vertex, Hint>::directed_edges() const {
  std::vector<DirectedEdge> directed;
  directed.reserve(6 * size());
  for (const auto& planar : triangulation_.finite_edges()) {
    const Edge edge = detail::edge_of(planar);
    directed.push_back({edge.a, edge.b});
    directed.push_back({edge.b, edge.a});
  }
  std::sort(directed.begin(), directed.end());
  return directed;
}

template <typename Vertex, typename Hint>
std::vector<Triangle> DelaunayTriangulation<Vertex, Hint>::inner_faces() const {
  std::vector<Triangle> faces;
  faces.reserve(2 * size());
  for (const FaceHandle face : triangulation_.finite_face_handles()) {
    faces.push_back(detail::triangle_of(face));
  }
  std::sort(faces.begin(), faces.end());
  return faces;
}

template <typename Vertex, typename Hint>
std::vector<NodeIndex> DelaunayTriangulation<Vertex, Hint>::convex_hull() const {
  std::vector<NodeIndex> hull;
  if (triangulation_.dimension() == 2) {
    detail::for_each_neighbor(triangulation_, triangulation_.infinite_vertex(),
                              [&](VertexHandle vertex) { hull.push_back(vertex->info()); });
    std::reverse(hull.begin(), hull.end());  // seen from infinity it runs clockwise
    std::rotate(hull.begin(), std::min_element(hull.begin(), hull.end()), hull.end());
  } else if (triangulation_.dimension() == 1) {
    std::vector<VertexHandle> ends;
    detail::for_each_neighbor(triangulation_, triangulation_.infinite_vertex(),
                              [&](VertexHandle vertex) { ends.push_back(vertex); });
    VertexHandle previous;
    VertexHandle next = ends[0]->info() < ends[1]->info() ? ends[0] : ends[1];
    while (next != VertexHandle()) {
      const VertexHandle current = std::exchange(next, VertexHandle());
      hull.push_back(current->info());
      detail::for_each_neighbor(triangulation_, current, [&](VertexHandle neighbor) {
        if (neighbor != previous) next = neighbor;
      });
      previous = current;
    }
  } else {
    hull = vertices();
  }
  return hull;
}

template <typename Vertex, typename Hint>
std::vector<NodeIndex> DelaunayTriangulation<Vertex, Hint>::neighbors(NodeIndex index) const {
  std::vector<NodeIndex> around;
  detail::for_each_neighbor(triangulation_, handle(index),
                            [&](VertexHandle vertex) { around.push_back(vertex->info()); });
  std::rotate(around.begin(), std::min_element(around.begin(), around.end()), around.end());
  return around;
}

template <typename Vertex, typename Hint>
bool DelaunayTriangulation<Vertex, Hint>::is_valid() const {
  if (!triangulation_.is_valid()) return false;
  if (vertices_.size() != handles_.size() || size() + free_.size() != handles_.size()) return false;
  for (const NodeIndex index : free_) {
    if (contains(index)) return false;
  }
  for (std::size_t i = 0; i < handles_.size(); ++i) {
    const bool used = contains(node_index(i));
    if (used != vertices_[i].has_value()) return false;
    if (!used) continue;
    if (handles_[i]->info() != node_index(i) || handles_[i]->point() != point_of(*vertices_[i])) {
      return false;
    }
  }
  return true;
}

template <typename Vertex, typename Hint>
PositionInTriangulation DelaunayTriangulation<Vertex, Hint>::locate(
    const Eigen::Vector2d& position) const {
  const Point point = checked_point(position);
  if (triangulation_.dimension() < 1) {
    if (empty() || triangulation_.finite_vertex()->point() != point) return NoTriangulation{};
    return OnVertex{triangulation_.finite_vertex()->info()};
  }
  typename Triangulation::Locate_type place;
  int i = 0;
  const FaceHandle face = triangulation_.locate(point, place, i, start_near(point));
  switch (place) {
    case Triangulation::VERTEX:
      hint_.notice(face->vertex(i)->info());
      return OnVertex{face->vertex(i)->info()};
    case Triangulation::EDGE: {
      const Edge edge = detail::edge_of(std::make_pair(face, i));
      hint_.notice(edge.a);
      return OnEdge{edge};
    }
    case Triangulation::FACE:
      hint_.notice(face->vertex(0)->info());
      return InFace{detail::triangle_of(face)};
    default:
      return OutsideOfConvexHull{};
  }
}

template <typename Vertex, typename Hint>
std::optional<NodeIndex> DelaunayTriangulation<Vertex, Hint>::nearest_neighbor(
    const Eigen::Vector2d& position) const {
  const Point point = checked_point(position);
  if (empty()) return std::nullopt;

  // Equally close vertices lie on one empty circle, so edges connect them.
  std::vector<VertexHandle> tied{closest_to(point)};
  NodeIndex nearest = tied.front()->info();
  for (std::size_t i = 0; i < tied.size(); ++i) {
    detail::for_each_neighbor(triangulation_, VertexHandle(tied[i]), [&](VertexHandle vertex) {
      if (is_closer(point, tied.front(), vertex)) return;
      if (std::find(tied.begin(), tied.end(), vertex) != tied.end()) return;
      tied.push_back(vertex);
      nearest = std::min(nearest, vertex->info());
    });
  }
  hint_.notice(nearest);
  return nearest;
}

/// A vertex none of whose neighbours is closer: in a Delaunay triangulation that is a closest one.
template <typename Vertex, typename Hint>
auto DelaunayTriangulation<Vertex, Hint>::closest_to(const Point& point) const -> VertexHandle {
  VertexHandle closest = triangulation_.finite_vertex();
  if (triangulation_.dimension() == 2) {
    const FaceHandle face = triangulation_.locate(point, start_near(point));
    closest = face->vertex(triangulation_.is_infinite(face->vertex(0)) ? 1 : 0);
  }
  VertexHandle next = closest;
  do {
    closest = next;
    detail::for_each_neighbor(triangulation_, closest, [&](VertexHandle vertex) {
      if (is_closer(point, vertex, next)) next = vertex;
    });
  } while (next != closest);
  return closest;
}

}  // namespace v0
}  // namespace topobag
