// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <iterator>
#include <map>
#include <optional>
#include <variant>
#include <vector>

#include <topobag/edges/delaunay_edges2.hpp>
#include <topobag/edges/delaunay_triangulation.hpp>

#include "catch.hpp"
#include "edges/planar_layouts.hpp"
#include "edges/planar_triangulations.hpp"
#include "edges/planar_truth.hpp"

using namespace topobag;
using namespace layouts;

namespace {

/// A user's hint: always the same vertex.
struct FixedHint {
  NodeIndex vertex{};
  std::optional<NodeIndex> suggest(const Eigen::Vector2d&) const { return vertex; }
  void notice(NodeIndex) const {}
};

/// What a test keeps beside a triangulation that changes: where each index lies.
using Places = std::map<std::size_t, Point>;

EdgeList edges_from_scratch(const Places& places) {
  Layout layout;
  std::vector<std::size_t> name;
  for (const auto& [index, point] : places) {
    name.push_back(index);
    layout.push_back(point);
  }
  return renamed(DelaunayEdges2{}(nodes_at(layout)), name);
}

std::size_t closest_by_brute_force(const Places& places, const Point& query) {
  auto best = places.begin();
  for (auto it = places.begin(); it != places.end(); ++it) {
    if (squared_distance(it->second, query) < squared_distance(best->second, query)) best = it;
  }
  return best->first;
}

/// Whether `place` is what lies at `query`, judged by the triangulation's edges and faces.
template <typename Triangulation>
bool is_at(const PositionInTriangulation& place, const Point& query, const Places& places,
           const Triangulation& triangulation) {
  for (const auto& [index, point] : places) {
    if (!(point == query)) continue;
    const OnVertex* on = std::get_if<OnVertex>(&place);
    return on != nullptr && value(on->vertex) == index;
  }
  if (places.size() < 2) return std::holds_alternative<NoTriangulation>(place);
  const auto at = [&](NodeIndex index) { return places.at(value(index)); };
  for (const Edge& edge : triangulation.undirected_edges()) {
    const Point a = at(edge.a), b = at(edge.b);
    const auto along =
        Wide(query.x - a.x) * (query.x - b.x) + Wide(query.y - a.y) * (query.y - b.y);
    if (orientation(a, b, query) != 0 || along > 0) continue;
    const OnEdge* on = std::get_if<OnEdge>(&place);
    return on != nullptr && on->edge == edge;
  }
  for (const Triangle& face : triangulation.inner_faces()) {
    if (orientation(at(face.a), at(face.b), query) <= 0 ||
        orientation(at(face.b), at(face.c), query) <= 0 ||
        orientation(at(face.c), at(face.a), query) <= 0) {
      continue;
    }
    const InFace* in = std::get_if<InFace>(&place);
    return in != nullptr && in->face == face;
  }
  return std::holds_alternative<OutsideOfConvexHull>(place);
}

/// A query near, on or between the points, or anywhere.
Point any_query(Random& random, const Layout& layout) {
  const auto pick = [&] {
    return layout[static_cast<std::size_t>(
        uniform(random, 0, static_cast<int>(layout.size()) - 1))];
  };
  const auto kind = layout.empty() ? 3 : uniform(random, 0, 3);
  if (kind == 0) return pick();
  if (kind == 1) {
    const Point a = pick(), b = pick();
    return {(a.x + b.x) / 2, (a.y + b.y) / 2};
  }
  if (kind == 2) {
    const Point a = pick(), offset = random_point(random, 2);
    return {a.x + offset.x, a.y + offset.y};
  }
  return random_point(random, 2000);
}

/// Random insertions and removals, each step checked, the edges compared with a bulk load.
template <typename Triangulation>
void check_random_sequence(Random& random, std::size_t round) {
  const Layout layout = any_layout(random, round, 24);
  const int exponent = static_cast<int>(uniform(random, -40, 40));
  Triangulation triangulation;
  Places places;
  std::size_t next = 0;
  while (next < layout.size() || !places.empty()) {
    const bool insert = next < layout.size() && (places.empty() || uniform(random, 0, 2) > 0);
    if (insert) {
      const Point point = layout[next++];
      const auto present = std::find_if(places.begin(), places.end(),
                                        [&](const auto& entry) { return entry.second == point; });
      const bool hinted = !places.empty() && uniform(random, 0, 1) == 0;
      const NodeIndex index =
          hinted ? triangulation.insert(scaled(point, exponent), node_index(places.begin()->first))
                 : triangulation.insert(scaled(point, exponent));
      if (present != places.end()) REQUIRE(value(index) == present->first);
      if (present == places.end()) REQUIRE(places.count(value(index)) == 0);
      places[value(index)] = point;
    } else {
      auto victim = places.begin();
      std::advance(victim, uniform(random, 0, static_cast<int>(places.size()) - 1));
      REQUIRE(triangulation.remove(node_index(victim->first)) == scaled(victim->second, exponent));
      places.erase(victim);
    }
    REQUIRE(triangulation.is_valid());
    REQUIRE(triangulation.size() == places.size());
    REQUIRE(triangulation.undirected_edges() == edges_from_scratch(places));
  }
  REQUIRE(triangulation.empty());
}

}  // namespace

TEST_CASE("insertions and removals in any order equal a bulk load", "[edges][delaunay]") {
  Random random(12);
  for (std::size_t round = 0; round < 5200; ++round) {
    INFO("round " << round);
    check_random_sequence<Planar>(random, round);
  }
}

TEST_CASE("a hint never changes the answer", "[edges][delaunay]") {
  Random random(13);
  for (std::size_t round = 0; round < 600; ++round) {
    INFO("round " << round);
    check_random_sequence<DelaunayTriangulation<Eigen::Vector2d, HierarchyHint>>(random, round);
    check_random_sequence<DelaunayTriangulation<Eigen::Vector2d, FixedHint>>(random, round);
  }
}

TEMPLATE_TEST_CASE("nearest neighbour and location equal brute force", "[edges][delaunay]",
                   LastUsedVertexHint, HierarchyHint, FixedHint) {
  Random random(14);
  for (std::size_t round = 0; round < 2000; ++round) {
    const Layout layout = any_layout(random, round);
    const int exponent = static_cast<int>(uniform(random, -40, 40));
    DelaunayTriangulation<Eigen::Vector2d, TestType> triangulation;
    triangulation.bulk_load(positions(layout, exponent));
    Places places;
    for (const std::size_t i : distinct(layout)) places[i] = layout[i];
    for (int repetition = 0; repetition < 10; ++repetition) {
      const Point query = any_query(random, layout);
      INFO("round " << round << ", query " << query.x << " " << query.y);
      const auto nearest = triangulation.nearest_neighbor(scaled(query, exponent));
      REQUIRE(nearest.has_value() == !places.empty());
      if (nearest) REQUIRE(value(*nearest) == closest_by_brute_force(places, query));
      const auto place = triangulation.locate(scaled(query, exponent));
      REQUIRE(is_at(place, query, places, triangulation));
    }
  }
}

TEMPLATE_TEST_CASE("large triangulations stay right", "[edges][delaunay]", LastUsedVertexHint,
                   HierarchyHint) {
  Random random(15);
  // Dense: with many points on one line and on one circle.
  const Layout layout = without_duplicates(scattered(random, 3000, 100));
  using Triangulation = DelaunayTriangulation<Eigen::Vector2d, TestType>;
  Triangulation grown;
  for (const Point& point : layout) grown.insert(scaled(point, 0));
  const std::size_t size = grown.size();
  Triangulation loaded;
  loaded.bulk_load(positions(layout));
  CHECK(grown.undirected_edges() == loaded.undirected_edges());

  for (std::size_t i = size; i-- > 1000;) grown.remove(node_index(i));
  CHECK(grown.is_valid());
  const Layout first(layout.begin(), layout.begin() + 1000);
  loaded.bulk_load(positions(first));
  CHECK(grown.undirected_edges() == loaded.undirected_edges());
  CHECK(grown.inner_faces() == loaded.inner_faces());
  for (int repetition = 0; repetition < 300; ++repetition) {
    const Point query = random_point(random, 400);
    REQUIRE(grown.locate(scaled(query, 0)).index() == loaded.locate(scaled(query, 0)).index());
    REQUIRE(grown.nearest_neighbor(scaled(query, 0)) == loaded.nearest_neighbor(scaled(query, 0)));
  }
}
