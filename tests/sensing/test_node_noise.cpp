// SPDX-License-Identifier: MIT
#include <cmath>
#include <random>

#include <Eigen/Eigenvalues>

#include <topobag/sensing/node_noise.hpp>

#include "catch.hpp"

using namespace topobag;

namespace {

/// Standard deviation along a direction, m.
double sigma(const Eigen::Matrix3d& covariance, const Eigen::Vector3d& direction) {
  const Eigen::Vector3d d = direction.normalized();
  return std::sqrt(d.dot(covariance * d));
}

}  // namespace

TEST_CASE("a node's covariance is symmetric and positive definite", "[sensing]") {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> side(-3.0, 3.0);
  std::uniform_real_distribution<double> z(0.1, 10.0);
  std::uniform_real_distribution<double> extent(0.0, 2.0);
  for (int i = 0; i < 1000; ++i) {
    const Eigen::Vector3d position(side(random), side(random), z(random));
    const Eigen::Matrix3d covariance =
        NodeNoise{}.covariance(position, {extent(random), extent(random)}, i % 2 == 0);
    CHECK(covariance == covariance.transpose());
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance);
    CHECK(solver.eigenvalues().minCoeff() > 0.0);
  }
}

TEST_CASE("the viewing ray is a principal axis", "[sensing]") {
  const Eigen::Vector3d position(0.5, -0.8, 2.0);
  const NodeNoise noise;
  const Eigen::Matrix3d covariance = noise.covariance(position, {0.4, 0.9}, false);
  const double object = std::sqrt(0.4 * 0.9);
  const double along =
      std::sqrt(0.01 * 0.01 + 0.005 * 4.0 * 0.005 * 4.0 + 0.1 * object * 0.1 * object);
  const double across = std::sqrt(0.01 * 0.01 + 0.06 * object * 0.06 * object);
  const Eigen::Vector3d ray = position.normalized();
  CHECK((covariance * ray - along * along * ray).norm() < 1e-15);
  const Eigen::Vector3d side = ray.unitOrthogonal();
  CHECK((covariance * side - across * across * side).norm() < 1e-15);
}

TEST_CASE("noise along the ray grows with depth, noise across it with the object", "[sensing]") {
  const NodeNoise noise;
  double last = 0.0;
  for (double z = 0.5; z < 8.0; z += 0.5) {
    const double s = sigma(noise.covariance({0, 0, z}, {0.3, 0.3}, false), {0, 0, 1});
    CHECK(s > last);
    last = s;
  }
  last = 0.0;
  for (double size = 0.1; size < 2.0; size += 0.1) {
    const double s = sigma(noise.covariance({0, 0, 2}, {size, size}, false), {1, 0, 0});
    CHECK(s > last);
    last = s;
  }
}

TEST_CASE("a cut box is less sure across the ray alone", "[sensing]") {
  const NodeNoise noise;
  const Eigen::Matrix3d whole = noise.covariance({0, 0, 2}, {0.5, 0.5}, false);
  const Eigen::Matrix3d cut = noise.covariance({0, 0, 2}, {0.5, 0.5}, true);
  CHECK(sigma(cut, {1, 0, 0}) > 1.5 * sigma(whole, {1, 0, 0}));
  CHECK(sigma(cut, {0, 0, 1}) == Approx(sigma(whole, {0, 0, 1})));
}

TEST_CASE("a node keeps its covariance; one that is not modelled gets the default noise",
          "[sensing]") {
  SemanticNode<float> node;
  node.position = Eigen::Vector3f(0.5F, -0.25F, 2.0F);
  node.size = {0.25F, 0.5F};
  CHECK(position_covariance(node) == NodeNoise{}.covariance({0.5, -0.25, 2.0}, {0.25, 0.5}, false));
  node.covariance = 0.25F * Eigen::Matrix3f::Identity();
  CHECK(position_covariance(node) == 0.25 * Eigen::Matrix3d::Identity());
}
