// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <topobag/sensing/lift_detections.hpp>
#include <topobag/sensing/range_detections.hpp>
#include <topobag/sensing/sparse_depth.hpp>
#include <topobag/types/class_catalog.hpp>

#include "catch.hpp"

using namespace topobag;

static_assert(tells_deviation_v<SparseBoxDepth, SparseDepth>);
static_assert(!tells_deviation_v<RobustBoxDepth, SparseDepth>);
static_assert(!tells_deviation_v<CenterDepth, SparseDepth>);

namespace {

const PinholeCamera<> depth_camera{500.0, 500.0, 320.0, 240.0, 640, 480};
const ClassCatalog depth_catalog = ClassCatalog::coco80();
const BoundingBox depth_box{350.0, 200.0, 450.0, 280.0};
const std::vector<Detection> one_depth_box{{depth_box, ClassId{41}, 0.9}};

/// Points all over the box, of an object at z that is a tenth of a metre deep, with noise in
/// proportion to their depth; and half as many of a wall behind it.
SparseDepth made_up_points(std::mt19937& random, std::size_t count, double z, double noise) {
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> x(depth_box.x1 + 15, depth_box.x2 - 15),
      y(depth_box.y1 + 15, depth_box.y2 - 15), deep(-0.05, 0.05);
  std::vector<DepthPoint> points;
  for (std::size_t i = 0; i < count; ++i) {
    points.push_back({{x(random), y(random)}, (z + deep(random)) * (1.0 + noise * normal(random))});
    if (i % 2 == 1) points.push_back({{x(random), y(random)}, z + 1.5 + 10.0 * deep(random)});
  }
  return SparseDepth(points);
}

/// The mean squared depth error over the variance along the ray.
struct DepthErrors {
  double told = 0.0;      ///< by the node's covariance
  double modelled = 0.0;  ///< by the noise of the options alone
};

DepthErrors depth_errors(std::size_t points, double noise) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> depth(1.0, 4.0);
  const std::size_t rounds = 1000;
  DepthErrors errors;
  for (std::size_t round = 0; round < rounds; ++round) {
    const double z = depth(random);
    const auto lifted = lift_detections(one_depth_box, made_up_points(random, points, z, noise),
                                        depth_camera, depth_catalog, {}, SparseBoxDepth{});
    REQUIRE(lifted.nodes.size() == 1);
    const SemanticNode<>& node = lifted.nodes.front();
    const Eigen::Vector3d ray = node.position->normalized();
    const double off = (node.z - z) / node.z * node.position->norm();
    const Eigen::Matrix3d modelled = NodeNoise{}.covariance(*node.position, node.size, false);
    errors.told += off * off / ray.dot(node.covariance * ray) / static_cast<double>(rounds);
    errors.modelled += off * off / ray.dot(modelled * ray) / static_cast<double>(rounds);
  }
  return errors;
}

}  // namespace

TEST_CASE("a depth deviates by how far the box's points are from it", "[sensing]") {
  const auto deviation = [](const std::vector<double>& depths) {
    std::vector<DepthPoint> points;
    for (const double z : depths) points.push_back({depth_box.center(), z});
    const auto estimate = SparseBoxDepth{}.estimate(SparseDepth(points), depth_box);
    REQUIRE(estimate);
    CHECK(estimate->z == 1.0);
    return estimate->deviation;
  };
  CHECK(deviation({1.0, 1.0, 1.0}) == 0.0);
  // Another surface, behind, and one before that has few points.
  CHECK(deviation({1.0, 1.0, 1.0, 1.0, 1.3, 1.3}) == Approx(std::sqrt(2 * 0.09 / 6)));
  CHECK(deviation({0.8, 1.0, 1.0, 1.0, 1.0}) == Approx(std::sqrt(0.04 / 5)));
  // A wild point counts as half the depth off.
  CHECK(deviation({1.0, 1.0, 1.0, 1e6}) == Approx(std::sqrt(0.25 / 4)));
}

TEST_CASE("an estimate's depth is the sampling's own", "[sensing]") {
  std::mt19937 random(2);
  for (const std::size_t points : {0U, 1U, 2U, 3U, 8U, 30U}) {
    for (int round = 0; round < 20; ++round) {
      const SparseDepth depth = made_up_points(random, points, 2.0, 0.05);
      const auto z = SparseBoxDepth{}(depth, depth_box);
      const auto estimate = SparseBoxDepth{}.estimate(depth, depth_box);
      REQUIRE(z.has_value() == estimate.has_value());
      REQUIRE(z.has_value() == (points > 2 || (points == 2 && depth.points().size() > 2)));
      if (z) CHECK(estimate->z == *z);
    }
  }
}

TEST_CASE("nodes of a few noisy points are as far off as their covariances say", "[sensing]") {
  for (const std::size_t points : {6U, 12U, 40U}) {
    for (const double noise : {0.01, 0.03, 0.06}) {
      CAPTURE(points, noise);
      CHECK(depth_errors(points, noise).told < 1.5);
    }
  }
  // Without, three points of 3 % and six of 6 % are taken for far surer than
  // they are.
  CHECK(depth_errors(3, 0.03).modelled > 1.3);
  CHECK(depth_errors(3, 0.03).told < 1.0);
  CHECK(depth_errors(6, 0.06).modelled > 2.5 * depth_errors(6, 0.06).told);
  CHECK(depth_errors(3, 0.06).modelled > 2.0 * depth_errors(3, 0.06).told);
  CHECK(depth_errors(3, 0.06).told < 4.0);
}

TEST_CASE("what points leave open of a depth stands beside the modelled noise", "[sensing]") {
  std::mt19937 random(3);
  const SparseDepth depth = made_up_points(random, 9, 2.0, 0.04);
  const auto estimate = SparseBoxDepth{}.estimate(depth, depth_box);
  REQUIRE(estimate);
  CHECK(estimate->deviation > 0.005);
  const auto lifted =
      lift_detections(one_depth_box, depth, depth_camera, depth_catalog, {}, SparseBoxDepth{});
  const SemanticNode<>& node = lifted.nodes.at(0);
  const Eigen::Matrix3d more =
      node.covariance - NodeNoise{}.covariance(*node.position, node.size, false);
  const Eigen::Vector3d along = *node.position * (estimate->deviation / node.z);
  CHECK((more - along * along.transpose()).norm() < 1e-12);
  CHECK(Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(more).eigenvalues()(0) > -1e-12);

  const auto ranged = range_detections(one_depth_box, depth, depth_camera, SparseBoxDepth{});
  CHECK(ranged.at(0).z == estimate->z);
  CHECK(ranged.at(0).z_deviation == estimate->deviation);
  CHECK(lift_detections(ranged, depth_camera, depth_catalog).nodes.at(0).covariance ==
        node.covariance);
}

TEST_CASE("a depth without a deviation has the modelled noise alone", "[sensing]") {
  const auto wall = [](const Eigen::Vector2d&) { return std::optional<double>(2.0); };
  const auto by_image = lift_detections(one_depth_box, wall, depth_camera, depth_catalog);
  auto ranged = range_detections(one_depth_box, wall, depth_camera);
  CHECK(ranged.at(0).z_deviation == 0.0);
  for (const double none : {0.0, -1.0, std::nan(""), HUGE_VAL}) {
    ranged[0].z_deviation = none;
    const auto lifted = lift_detections(ranged, depth_camera, depth_catalog);
    const SemanticNode<>& node = lifted.nodes.at(0);
    CHECK(node.covariance == NodeNoise{}.covariance(*node.position, node.size, false));
    CHECK(node.covariance == by_image.nodes.at(0).covariance);
  }
  // No points, no depth, and no deviation either.
  const auto nothing =
      range_detections(one_depth_box, SparseDepth({}), depth_camera, SparseBoxDepth{});
  CHECK(nothing.at(0).z == 0.0);
  CHECK(nothing.at(0).z_deviation == 0.0);
}
