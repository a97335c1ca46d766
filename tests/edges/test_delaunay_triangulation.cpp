// SPDX-License-Identifier: MIT
#include <initializer_list>
#include <limits>
#include <string>
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

/// A user's vertex: its place under other names, and a payload.
struct Landmark {
  double east = 0.0;
  double north = 0.0;
  std::string name;
};

std::vector<NodeIndex> indices(std::initializer_list<unsigned> list) {
  std::vector<NodeIndex> result;
  for (const unsigned i : list) result.push_back(node_index(i));
  return result;
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
