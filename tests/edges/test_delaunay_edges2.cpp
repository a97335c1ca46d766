// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include <topobag/edges/delaunay_edges2.hpp>

#include "catch.hpp"
#include "edges/planar_layouts.hpp"
#include "edges/planar_truth.hpp"

using namespace topobag;
using namespace layouts;

namespace {

EdgeList edges(std::initializer_list<std::pair<unsigned, unsigned>> pairs) {
  EdgeList list;
  for (const auto& [a, b] : pairs) list.push_back({node_index(a), node_index(b)});
  return list;
}

bool is_canonical(const EdgeList& list) {
  return std::is_sorted(list.begin(), list.end()) &&
         std::adjacent_find(list.begin(), list.end()) == list.end() &&
         std::all_of(list.begin(), list.end(), [](const Edge& edge) { return edge.a < edge.b; });
}

/// The number of edges that any triangulation of the distinct points has, twins added.
std::size_t expected_edges(const Layout& layout, const DelaunayTruth& truth) {
  const std::size_t n = distinct(layout).size();
  const std::size_t twins = layout.size() - n;
  if (truth.on_line) return twins + (n > 0 ? n - 1 : 0);
  return twins + 3 * n - 3 - truth.hull;
}

}  // namespace

TEST_CASE("Delaunay edges of the smallest layouts", "[edges][delaunay]") {
  const DelaunayEdges2 build;
  CHECK(build(nodes_at({})).empty());
  CHECK(build(nodes_at({{1, 2}})).empty());
  CHECK(build(nodes_at({{1, 2}, {3, 4}})) == edges({{0, 1}}));
  CHECK(build(nodes_at({{0, 0}, {1, 0}, {0, 1}})) == edges({{0, 1}, {0, 2}, {1, 2}}));
}

TEST_CASE("nodes on one line give a path", "[edges][delaunay]") {
  CHECK(DelaunayEdges2{}(nodes_at({{0, 0}, {30, 10}, {9, 3}, {-3, -1}})) ==
        edges({{0, 2}, {0, 3}, {1, 2}}));
}

TEST_CASE("of coincident nodes the first is triangulated and the others hang on it",
          "[edges][delaunay]") {
  CHECK(DelaunayEdges2{}(nodes_at({{5, 5}, {5, 5}, {5, 5}})) == edges({{0, 1}, {0, 2}}));
  CHECK(DelaunayEdges2{}(nodes_at({{0, 0}, {4, 0}, {0, 0}, {0, 4}, {4, 0}})) ==
        edges({{0, 1}, {0, 2}, {0, 3}, {1, 3}, {1, 4}}));
}

TEST_CASE("nodes without a pixel stay isolated", "[edges][delaunay]") {
  auto nodes = nodes_at({{0, 0}, {4, 0}, {1, 1}, {0, 4}});
  nodes[2].pixel.reset();
  CHECK(DelaunayEdges2{}(nodes) == edges({{0, 1}, {0, 3}, {1, 3}}));
}

TEST_CASE("nodes of float are triangulated as the doubles they equal", "[edges][delaunay]") {
  std::vector<SemanticNode<float>> nodes(4);
  nodes[0].pixel = Eigen::Vector2f(0.1f, 0.2f);
  nodes[1].pixel = Eigen::Vector2f(5.0f, 0.1f);
  nodes[2].pixel = Eigen::Vector2f(2.0f, 7.0f);
  nodes[3].pixel = Eigen::Vector2f(2.0f, 2.0f);
  CHECK(DelaunayEdges2{}(nodes) == edges({{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}));
}

TEST_CASE("bad coordinates are refused with the node's index", "[edges][delaunay]") {
  const auto fault_of = [](double bad) -> std::optional<CoordinateFault> {
    auto nodes = nodes_at({{0, 0}, {1, 0}, {2, 3}});
    nodes[2].pixel->y() = bad;
    try {
      DelaunayEdges2{}(nodes);
    } catch (const InsertionError& error) {
      CHECK(error.index() == 2u);
      return error.fault();
    }
    return std::nullopt;
  };
  CHECK(fault_of(std::numeric_limits<double>::quiet_NaN()) == CoordinateFault::nan);
  CHECK(fault_of(-std::numeric_limits<double>::infinity()) == CoordinateFault::infinite);
  CHECK(fault_of(-0x1.1p201) == CoordinateFault::too_large);
  CHECK(fault_of(0x1p-143) == CoordinateFault::too_small);
  CHECK_FALSE(fault_of(0x1p201).has_value());
  CHECK_FALSE(fault_of(-0x1p-142).has_value());
  CHECK_FALSE(fault_of(-0.0).has_value());
}

TEST_CASE("Delaunay edges equal brute force on 16,000 layouts", "[edges][delaunay]") {
  Random random(1);
  std::size_t unique = 0, on_line = 0;
  for (std::size_t round = 0; round < 16000; ++round) {
    const Layout layout = any_layout(random, round);
    const int exponent = static_cast<int>(uniform(random, -40, 40));
    const DelaunayTruth truth = delaunay_truth(layout);
    const EdgeList found = DelaunayEdges2{}(nodes_at(layout, exponent));
    INFO("round " << round << ", " << layout.size() << " points");
    REQUIRE(is_canonical(found));
    REQUIRE(found.size() == expected_edges(layout, truth));
    if (truth.unique) {
      REQUIRE(found == truth.edges);
    } else {
      REQUIRE(std::includes(truth.edges.begin(), truth.edges.end(), found.begin(), found.end()));
    }
    unique += truth.unique;
    on_line += truth.on_line && layout.size() > 2;
  }
  CHECK(unique > 5000);
  CHECK(unique < 13000);
  CHECK(on_line > 1500);
}

TEST_CASE("the whole allowed range is exact", "[edges][delaunay]") {
  Random random(7);
  for (std::size_t round = 0; round < 400; ++round) {
    const Layout layout = any_layout(random, round);
    const EdgeList expected = DelaunayEdges2{}(nodes_at(layout));
    for (const int exponent : {-142, -120, 120, 181}) {
      REQUIRE(DelaunayEdges2{}(nodes_at(layout, exponent)) == expected);
    }
  }
  auto nodes = nodes_at({{0, 0}, {1, 0}, {0, 1}, {-1, 0}, {3, -7}});
  nodes[0].pixel = Eigen::Vector2d(0x1p-142, -0x1p-142);
  nodes[1].pixel = Eigen::Vector2d(0x1p201, 0x1p-142);
  nodes[2].pixel = Eigen::Vector2d(-0x1p-142, 0x1p201);
  nodes[3].pixel = Eigen::Vector2d(-0x1p201, -0x1p201);
  CHECK(DelaunayEdges2{}(nodes).size() == 3 * 5 - 3 - 3);
}

TEST_CASE("ten points on which an inexact triangulator was seen not to return",
          "[edges][delaunay]") {
  std::vector<SemanticNode<>> nodes;
  for (const auto& [u, v] :
       std::vector<std::pair<double, double>>{{454.36579174380364, 293.54021740806286},
                                              {254.32814856473124, 194.15345905807172},
                                              {39.515407041973099, 458.58346747458052},
                                              {141.57125951114918, 476.40666764226972},
                                              {169.78775188914301, 315.12578190865577},
                                              {179.24604534044732, 302.266488421654},
                                              {529.9857455537973, 155.72328060293137},
                                              {42.178869509837412, 437.01103809761673},
                                              {427.58129165252279, 419.69789690154153},
                                              {64.722028355081221, 338.97504686638888}}) {
    nodes.emplace_back().pixel = Eigen::Vector2d(u, v);
  }
  const EdgeList found = DelaunayEdges2{}(nodes);
  CHECK(is_canonical(found));
  CHECK(found.size() == 3 * 10 - 3 - 7);
}

TEST_CASE("planes other than the image's", "[edges][delaunay]") {
  // A floor plan of four points in general position, seen by a tilted camera, heights at random.
  const Eigen::Matrix3d R_camera_world =
      Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  const Layout plan = {{0, 0}, {50, 3}, {20, 60}, {24, 21}, {70, 44}};
  const EdgeList expected = DelaunayEdges2{}(nodes_at(plan));
  const double heights[] = {1, -2, 0.5, 3, -1};
  std::vector<SemanticNode<>> nodes(plan.size());
  for (std::size_t i = 0; i < plan.size(); ++i) {
    const Eigen::Vector2d place = scaled(plan[i], 0);
    nodes[i].position = R_camera_world * Eigen::Vector3d(place.x(), place.y(), heights[i]);
  }
  const Eigen::Vector3d gravity = R_camera_world * Eigen::Vector3d(0, 0, -9.81);
  CHECK(DelaunayEdges2{GroundPlane(gravity)}(nodes) == expected);
  CHECK(DelaunayEdges2{BestFitPlane{}}(nodes) == expected);
  CHECK(DelaunayEdges2{}(nodes).empty());  // no pixels

  nodes[3].position->z() = std::numeric_limits<double>::infinity();
  CHECK_THROWS_AS(DelaunayEdges2{BestFitPlane{}}(nodes), InsertionError);
  CHECK_THROWS_AS(DelaunayEdges2{GroundPlane(gravity)}(nodes), InsertionError);
}

TEST_CASE("a user's own projection is a callable", "[edges][delaunay]") {
  const auto nodes = nodes_at({{0, 0}, {10, 1}, {20, 30}});
  const auto onto_u_axis = [](const auto&) {
    return [](const SemanticNode<>& node) {
      return std::optional<Eigen::Vector2d>({node.pixel->x(), 0.0});
    };
  };
  CHECK(DelaunayEdges2{onto_u_axis}(nodes) == edges({{0, 1}, {1, 2}}));
}
