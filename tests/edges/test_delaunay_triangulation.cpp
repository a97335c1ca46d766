// SPDX-License-Identifier: MIT
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <thread>

#include <topobag/edges/delaunay_edges2.hpp>
#include <topobag/edges/delaunay_triangulation.hpp>

#include "catch.hpp"
#include "edges/planar_layouts.hpp"

using namespace topobag;
using namespace layouts;

namespace {

/// A user's vertex: its place under other names, and a payload.
struct Landmark {
  double east = 0.0;
  double north = 0.0;
  std::string name;
};

/// A user's hint: always the same vertex.
struct FixedHint {
  NodeIndex vertex{};
  std::optional<NodeIndex> suggest(const Eigen::Vector2d&) const { return vertex; }
  void notice(NodeIndex) const {}
};

using Planar = DelaunayTriangulation<Eigen::Vector2d>;

std::vector<Eigen::Vector2d> positions(const Layout& layout, int exponent = 0) {
  std::vector<Eigen::Vector2d> result;
  for (const Point& point : layout) result.push_back(scaled(point, exponent));
  return result;
}

std::vector<NodeIndex> indices(std::initializer_list<unsigned> list) {
  std::vector<NodeIndex> result;
  for (const unsigned i : list) result.push_back(node_index(i));
  return result;
}

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

template <>
struct topobag::PositionTraits<Landmark> {
  static Eigen::Vector2d position(const Landmark& landmark) {
    return {landmark.east, landmark.north};
  }
};

TEST_CASE("a triangulation of the user's own vertices", "[edges][delaunay]") {
  DelaunayTriangulation<Landmark> map;
  const NodeIndex desk = map.insert({0, 0, "desk"});
  const NodeIndex door = map.insert({4, 0, "door"});
  const NodeIndex lamp = map.insert({0, 3, "lamp"}, door);
  CHECK(map.size() == 3);
  CHECK(map.vertex(lamp).name == "lamp");
  CHECK(map.position(door) == Eigen::Vector2d(4, 0));
  CHECK(map.vertices() == std::vector<NodeIndex>{desk, door, lamp});
  CHECK(map.nearest_neighbor({3, 0.5}) == door);
  CHECK(map.locate_vertex({0, 3}) == lamp);
  CHECK_FALSE(map.locate_vertex({1, 1}).has_value());

  SECTION("the same position again replaces the vertex and keeps its index") {
    CHECK(map.insert({4, 0, "window"}) == door);
    CHECK(map.size() == 3);
    CHECK(map.vertex(door).name == "window");
    CHECK(map.is_valid());
  }
  SECTION("removal frees one index and moves no other") {
    CHECK(map.remove(desk).name == "desk");
    CHECK_FALSE(map.contains(desk));
    CHECK(map.vertex(lamp).name == "lamp");
    CHECK(map.undirected_edges() == EdgeList{{door, lamp}});
    CHECK_THROWS_AS(map.remove(desk), InvalidId);
    CHECK_THROWS_AS(map.vertex(desk), InvalidId);
    CHECK_THROWS_AS(map.neighbors(node_index(99)), InvalidId);
    CHECK_THROWS_AS(map.insert({9, 9, "far"}, desk), InvalidId);
    CHECK(map.insert({1, 1, "cup"}) == desk);
    CHECK(map.is_valid());
  }
  SECTION("a refused position changes nothing") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK_THROWS_AS(map.insert({nan, 0, "ghost"}), InsertionError);
    CHECK_THROWS_AS(map.insert({0x1p-143, 0, "ghost"}, door), InsertionError);
    CHECK_THROWS_AS(map.locate({0, nan}), InsertionError);
    CHECK_THROWS_AS(map.nearest_neighbor({1e300, 0}), InsertionError);
    try {
      map.bulk_load({{0, 0, "a"}, {1, std::numeric_limits<double>::infinity(), "b"}});
      FAIL("accepted an infinite coordinate");
    } catch (const InsertionError& error) {
      CHECK(error.index() == 1u);
      CHECK(error.fault() == CoordinateFault::infinite);
    }
    CHECK(map.size() == 3);
    CHECK(map.vertex(desk).name == "desk");
    CHECK(map.is_valid());
  }
  SECTION("cleared, it can be filled again") {
    map.clear();
    CHECK(map.empty());
    CHECK(map.is_valid());
    map.reserve(2);
    CHECK(map.insert({1, 2, "again"}) == node_index(0));
  }
}

TEST_CASE("semantic nodes lie at their pixels", "[edges][delaunay]") {
  DelaunayTriangulation<SemanticNode<float>> triangulation;
  SemanticNode<float> node;
  CHECK_THROWS_AS(triangulation.insert(node), InsertionError);
  node.pixel = Eigen::Vector2f(3, 4);
  node.z = 2.5f;
  CHECK(triangulation.vertex(triangulation.insert(node)).z == 2.5f);
}

TEST_CASE("bulk load: index i is the i-th input, and losses are reported", "[edges][delaunay]") {
  Planar triangulation;
  triangulation.insert({77, 77});
  const auto lost = triangulation.bulk_load(positions({{0, 0}, {4, 0}, {0, 0}, {0, 4}, {4, 0}}));
  REQUIRE(lost.size() == 2);
  CHECK((lost[0].lost == node_index(2) && lost[0].kept == node_index(0)));
  CHECK((lost[1].lost == node_index(4) && lost[1].kept == node_index(1)));
  CHECK(triangulation.vertices() == indices({0, 1, 3}));
  CHECK(triangulation.vertex(node_index(3)) == Eigen::Vector2d(0, 4));
  CHECK(triangulation.is_valid());
  CHECK(triangulation.insert({9, 9}) == node_index(2));
  CHECK(triangulation.insert({9, 8}) == node_index(4));
  CHECK(triangulation.insert({9, 7}) == node_index(5));
}

TEST_CASE("the degenerate triangulations are defined", "[edges][delaunay]") {
  Planar triangulation;
  const auto is = [&](const Eigen::Vector2d& query) { return triangulation.locate(query).index(); };
  CHECK_FALSE(triangulation.nearest_neighbor({0, 0}).has_value());
  CHECK(is({0, 0}) == PositionInTriangulation(NoTriangulation{}).index());
  CHECK(triangulation.convex_hull().empty());

  triangulation.insert({1, 1});
  CHECK(is({0, 0}) == PositionInTriangulation(NoTriangulation{}).index());
  CHECK(is({1, 1}) == PositionInTriangulation(OnVertex{}).index());
  CHECK(triangulation.nearest_neighbor({0, 0}) == node_index(0));
  CHECK(triangulation.neighbors(node_index(0)).empty());
  CHECK(triangulation.convex_hull() == indices({0}));

  triangulation.insert({5, 5});
  triangulation.insert({3, 3});
  CHECK(is({2, 2}) == PositionInTriangulation(OnEdge{}).index());
  CHECK(is({2, 3}) == PositionInTriangulation(OutsideOfConvexHull{}).index());
  CHECK(is({6, 6}) == PositionInTriangulation(OutsideOfConvexHull{}).index());
  CHECK(triangulation.convex_hull() == indices({0, 2, 1}));
  CHECK(triangulation.neighbors(node_index(2)) == indices({0, 1}));
  CHECK(triangulation.inner_faces().empty());
  CHECK(triangulation.directed_edges().size() == 4);

  triangulation.insert({5, 1});
  CHECK(is({4, 2.5}) == PositionInTriangulation(InFace{}).index());
  CHECK(triangulation.convex_hull() == indices({0, 3, 1, 2}));
}

TEST_CASE("edges, faces, hull and neighbours agree and are Delaunay", "[edges][delaunay]") {
  Random random(11);
  for (std::size_t round = 0; round < 3000; ++round) {
    const Layout layout = any_layout(random, round);
    INFO("round " << round << ", " << layout.size() << " points");
    Planar triangulation;
    const auto lost =
        triangulation.bulk_load(positions(layout, static_cast<int>(uniform(random, -40, 40))));
    REQUIRE(triangulation.is_valid());

    const auto twins = first_twins(layout);
    for (const auto& loss : lost) REQUIRE(twins[value(loss.lost)] == value(loss.kept));
    REQUIRE(lost.size() + triangulation.size() == layout.size());
    REQUIRE(triangulation.size() == distinct(layout).size());

    const EdgeList edges = triangulation.undirected_edges();
    EdgeList with_twins = edges;
    for (const auto& loss : lost) with_twins.push_back({loss.kept, loss.lost});
    make_canonical(with_twins);
    REQUIRE(with_twins == DelaunayEdges2{}(nodes_at(layout)));

    const auto directed = triangulation.directed_edges();
    REQUIRE(directed.size() == 2 * edges.size());
    REQUIRE(std::is_sorted(directed.begin(), directed.end()));
    auto out = directed.begin();
    for (const NodeIndex index : triangulation.vertices()) {
      auto neighbors = triangulation.neighbors(index);
      if (neighbors.size() > 2) {  // each turns left of the one before, but for one gap
        int right_turns = 0;
        const auto at = [&](NodeIndex i) { return layout[value(i)]; };
        for (std::size_t i = 0; i < neighbors.size(); ++i) {
          const auto next = neighbors[(i + 1) % neighbors.size()];
          right_turns += orientation(at(index), at(neighbors[i]), at(next)) <= 0;
        }
        REQUIRE(right_turns <= 1);
      }
      std::sort(neighbors.begin(), neighbors.end());
      for (const NodeIndex neighbor : neighbors) {
        REQUIRE(*out == DirectedEdge{index, neighbor});
        ++out;
      }
    }

    const auto hull = triangulation.convex_hull();
    const auto faces = triangulation.inner_faces();
    const DelaunayTruth truth = delaunay_truth(layout);
    if (!truth.on_line) {
      const auto n = triangulation.size();
      REQUIRE(hull.size() == truth.hull);
      REQUIRE(faces.size() == 2 * n - 2 - hull.size());
      for (std::size_t i = 0; i < hull.size(); ++i) {
        const Point from = layout[value(hull[i])], to = layout[value(hull[(i + 1) % hull.size()])];
        for (const Point& point : layout) REQUIRE(orientation(from, to, point) >= 0);
      }
    } else {
      REQUIRE(hull.size() == triangulation.size());
      REQUIRE(faces.empty());
    }
    if (!hull.empty() && !truth.on_line) {
      REQUIRE(hull.front() == *std::min_element(hull.begin(), hull.end()));
    }
    EdgeList of_faces;
    for (const Triangle& face : faces) {
      REQUIRE((face.a < face.b && face.a < face.c));
      const Point a = layout[value(face.a)], b = layout[value(face.b)], c = layout[value(face.c)];
      REQUIRE(orientation(a, b, c) > 0);
      for (const Point& point : layout) REQUIRE(in_circle(a, b, c, point) <= 0);
      of_faces.push_back(make_edge(face.a, face.b));
      of_faces.push_back(make_edge(face.b, face.c));
      of_faces.push_back(make_edge(face.c, face.a));
    }
    make_canonical(of_faces);
    if (!truth.on_line) REQUIRE(of_faces == edges);
  }
}

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

TEMPLATE_TEST_CASE("copies share nothing, and a moved-from triangulation is empty",
                   "[edges][delaunay]", LastUsedVertexHint, HierarchyHint) {
  Random random(16);
  using Triangulation = DelaunayTriangulation<Eigen::Vector2d, TestType>;
  Triangulation original;
  original.bulk_load(positions(scattered(random, 400, 100)));
  const EdgeList edges = original.undirected_edges();

  Triangulation copy(original);
  CHECK(copy.undirected_edges() == edges);
  const NodeIndex some = copy.vertices().front();
  copy.remove(some);
  copy.insert({1000, 1000});
  CHECK(copy.is_valid());
  CHECK(original.is_valid());
  CHECK(original.undirected_edges() == edges);

  Triangulation moved(std::move(original));
  CHECK(moved.undirected_edges() == edges);
  CHECK(original.empty());
  CHECK(original.is_valid());
  CHECK(original.insert({1, 2}) == node_index(0));

  copy = moved;
  CHECK(copy.undirected_edges() == edges);
  const Triangulation& self = copy;
  copy = self;
  CHECK(copy.undirected_edges() == edges);
  original = std::move(moved);
  CHECK(original.undirected_edges() == edges);
  CHECK(original.is_valid());
  CHECK(moved.is_valid());
  original.remove(some);
  CHECK(original.is_valid());
}

TEST_CASE("any number of threads may ask at once", "[edges][delaunay]") {
  Random random(17);
  Planar triangulation;
  triangulation.bulk_load(positions(without_duplicates(scattered(random, 2000, 1000))));
  const Planar& shared = triangulation;
  std::vector<Eigen::Vector2d> queries;
  for (int i = 0; i < 1000; ++i) queries.push_back(scaled(random_point(random, 1100), 0));
  const auto answers = [&] {
    std::vector<std::size_t> result;
    for (const auto& query : queries) {
      result.push_back(value(*shared.nearest_neighbor(query)));
      result.push_back(shared.locate(query).index());
      result.push_back(shared.neighbors(node_index(result.size() % shared.size())).size());
    }
    result.push_back(shared.undirected_edges().size());
    result.push_back(shared.convex_hull().size());
    result.push_back(shared.is_valid());
    return result;
  };
  std::vector<std::vector<std::size_t>> results(5);
  std::vector<std::thread> threads;
  for (std::size_t t = 1; t < results.size(); ++t) {
    threads.emplace_back([&, t] { results[t] = answers(); });
  }
  for (std::thread& thread : threads) thread.join();
  results[0] = answers();
  for (const auto& result : results) CHECK(result == results[0]);
}
