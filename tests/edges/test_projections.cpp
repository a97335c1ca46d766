// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>
#include <random>

#include <topobag/edges/projections.hpp>

#include "catch.hpp"

using namespace topobag;

namespace {

std::vector<SemanticNode<>> nodes_at(const std::vector<Eigen::Vector3d>& positions) {
  std::vector<SemanticNode<>> nodes;
  for (const auto& position : positions) nodes.emplace_back().position = position;
  return nodes;
}

}  // namespace

TEST_CASE("the image plane is the pixel", "[edges][delaunay]") {
  std::vector<SemanticNode<float>> nodes(2);
  nodes[0].pixel = Eigen::Vector2f(3.5f, 4.25f);
  const auto project = ImagePlane{}(nodes);
  CHECK(project(nodes[0]) == Eigen::Vector2d(3.5, 4.25));
  CHECK_FALSE(project(nodes[1]).has_value());
}

TEST_CASE("the ground plane keeps horizontal distances and forgets heights", "[edges][delaunay]") {
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  const auto vector = [&] {
    return Eigen::Vector3d(normal(random), normal(random), normal(random));
  };
  for (int round = 0; round < 1000; ++round) {
    const Eigen::Vector3d gravity = vector();
    const auto nodes = nodes_at({vector(), vector()});
    const auto project = GroundPlane(gravity)(nodes);
    const Eigen::Vector3d offset = *nodes[1].position - *nodes[0].position;
    const double height = offset.dot(gravity.normalized());
    const Eigen::Vector2d seen = *project(nodes[1]) - *project(nodes[0]);
    REQUIRE(seen.norm() == Approx(std::sqrt(offset.squaredNorm() - height * height)).margin(1e-9));
  }
  const std::vector<SemanticNode<>> unplaced(1);
  CHECK_FALSE(GroundPlane(Eigen::Vector3d::UnitY())(unplaced)(unplaced[0]).has_value());
}

TEST_CASE("gravity of any length will do, but it needs a direction", "[edges][delaunay]") {
  CHECK_NOTHROW(GroundPlane(Eigen::Vector3d(0, 1e-300, 0)));
  CHECK_NOTHROW(GroundPlane(Eigen::Vector3d(1e300, 1e300, 1e300)));
  CHECK_THROWS_AS(GroundPlane(Eigen::Vector3d::Zero()), InvalidValue);
  CHECK_THROWS_AS(GroundPlane(Eigen::Vector3d(0, std::numeric_limits<double>::quiet_NaN(), 0)),
                  InvalidValue);
}

TEST_CASE("the best-fit plane keeps distances inside a plane of any pose", "[edges][delaunay]") {
  const Eigen::Isometry3d pose = Eigen::Translation3d(1, 2, 3) *
                                 Eigen::AngleAxisd(0.8, Eigen::Vector3d(1, -2, 2).normalized());
  std::vector<Eigen::Vector3d> wall;
  for (int i = 0; i < 12; ++i) wall.push_back(pose * Eigen::Vector3d(i % 4, i * i % 7, 0.0));
  auto nodes = nodes_at(wall);
  nodes.emplace_back();
  const auto project = BestFitPlane{}(nodes);
  for (std::size_t i = 0; i < wall.size(); ++i) {
    const double distance = (wall[i] - wall[0]).norm();
    CHECK((*project(nodes[i]) - *project(nodes[0])).norm() == Approx(distance).margin(1e-9));
  }
  CHECK_FALSE(project(nodes.back()).has_value());
}

TEST_CASE("a best-fit plane is defined for any number of nodes", "[edges][delaunay]") {
  CHECK_NOTHROW(BestFitPlane{}(std::vector<SemanticNode<>>{}));
  for (const auto& nodes : {nodes_at({{1, 2, 3}}), nodes_at({{1, 2, 3}, {1, 2, 3}})}) {
    CHECK(BestFitPlane{}(nodes)(nodes[0])->allFinite());
  }
  auto nodes = nodes_at({{1, 2, 3}, {4, 5, 6}});
  nodes[1].position->x() = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(BestFitPlane{}(nodes), InvalidValue);
}
