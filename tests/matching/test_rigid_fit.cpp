// SPDX-License-Identifier: MIT
#include <cmath>
#include <random>

#include <Eigen/Geometry>

#include <topobag/matching/rigid_fit.hpp>

#include "catch.hpp"
#include "matching/layouts.hpp"

using namespace topobag;

namespace {

Eigen::Matrix3Xd random_points(std::mt19937& random, Eigen::Index count) {
  std::normal_distribution<double> metres;
  Eigen::Matrix3Xd points(3, count);
  for (Eigen::Index i = 0; i < points.size(); ++i) points(i) = metres(random);
  return points;
}

Eigen::Matrix3Xd transformed(const Eigen::Isometry3d& T, const Eigen::Matrix3Xd& points) {
  return (T.linear() * points).colwise() + T.translation();
}

/// Weighted sum of squares, weights summing to 1.
double cost(const Eigen::Isometry3d& T, const Eigen::Matrix3Xd& target,
            const Eigen::Matrix3Xd& source, const Eigen::VectorXd& weights) {
  return (target - transformed(T, source)).colwise().squaredNorm().dot(weights) / weights.sum();
}

bool is_rotation(const Eigen::Matrix3d& R) {
  return (R * R.transpose() - Eigen::Matrix3d::Identity()).norm() < 1e-12 &&
         std::abs(R.determinant() - 1.0) < 1e-12;
}

}  // namespace

TEST_CASE("a rigid fit recovers any motion exactly", "[matching]") {
  std::mt19937 random(41);
  for (int round = 0; round < 500; ++round) {
    const Eigen::Matrix3Xd source = random_points(random, 3 + round % 8);
    const Eigen::Isometry3d T = random_motion(random, 10.0);
    const auto fit = fit_rigid(transformed(T, source), source);
    REQUIRE(fit);
    CHECK(fit->T_target_source.matrix().isApprox(T.matrix(), 1e-9));
    CHECK(fit->rms < 1e-12);
    CHECK(is_rotation(fit->T_target_source.linear()));
  }
}

TEST_CASE("no motion near the fit has a smaller weighted sum of squares", "[matching]") {
  std::mt19937 random(42);
  std::uniform_real_distribution<double> weight(0.1, 5.0);
  std::normal_distribution<double> small(0.0, 1e-3), large(0.0, 0.5);
  for (int round = 0; round < 100; ++round) {
    const Eigen::Matrix3Xd source = random_points(random, 6);
    const Eigen::Matrix3Xd target =
        transformed(random_motion(random, 2.0), source) + 0.2 * random_points(random, 6);
    Eigen::VectorXd weights(6);
    for (double& w : weights) w = weight(random);
    const auto fit = fit_rigid(target, source, weights);
    REQUIRE(fit);
    const double least = cost(fit->T_target_source, target, source, weights);
    CHECK(fit->rms == Approx(std::sqrt(least)));
    for (int trial = 0; trial < 60; ++trial) {
      auto& step = trial % 2 == 0 ? small : large;
      const double a = step(random), b = step(random), c = step(random), angle = step(random);
      const Eigen::Vector3d axis = random_points(random, 1).col(0).normalized();
      Eigen::Isometry3d other = fit->T_target_source;
      other.linear() = Eigen::AngleAxisd(angle, axis) * other.linear();
      other.translation() += Eigen::Vector3d(a, b, c);
      CHECK(cost(other, target, source, weights) >= least - 1e-12);
    }
  }
}

TEST_CASE("a mirror image is fitted by a rotation, and badly", "[matching]") {
  std::mt19937 random(43);
  for (int round = 0; round < 100; ++round) {
    const Eigen::Matrix3Xd source = random_points(random, 5);
    Eigen::Matrix3Xd target = source;
    target.row(0) *= -1.0;
    const auto fit = fit_rigid(target, source);
    REQUIRE(fit);
    CHECK(is_rotation(fit->T_target_source.linear()));
    CHECK(fit->rms > 1e-3);
  }
}

TEST_CASE("points in a plane are fitted by a rotation", "[matching]") {
  std::mt19937 random(44);
  for (int round = 0; round < 100; ++round) {
    Eigen::Matrix3Xd source = random_points(random, 3 + round % 4);
    source.row(2).setConstant(3.0);
    const Eigen::Isometry3d T = random_motion(random, 3.0);
    const auto fit = fit_rigid(transformed(T, source), source);
    REQUIRE(fit);
    CHECK(is_rotation(fit->T_target_source.linear()));
    CHECK(fit->T_target_source.matrix().isApprox(T.matrix(), 1e-9));
  }
}

TEST_CASE("points on a line are carried onto it, without a spread", "[matching]") {
  std::mt19937 random(45);
  for (int round = 0; round < 50; ++round) {
    Eigen::Matrix3Xd source = random_points(random, 4);
    source.bottomRows(2).colwise() = Eigen::Vector2d(1.0, 2.0);
    const Eigen::Matrix3Xd target = transformed(random_motion(random, 3.0), source);
    const auto fit = fit_rigid(target, source);
    REQUIRE(fit);
    CHECK(is_rotation(fit->T_target_source.linear()));
    CHECK(transformed(fit->T_target_source, source).isApprox(target, 1e-9));
    CHECK(fit->spread == Approx(0.0).margin(1e-7));
  }
}

TEST_CASE("the spread is the r.m.s. distance from the best line", "[matching]") {
  Eigen::Matrix3Xd points(3, 4);
  points << 5.0, 5.0, -5.0, -5.0,  //
      1.0, -1.0, 1.0, -1.0,        //
      0.0, 0.0, 0.0, 0.0;
  CHECK(fit_rigid(points, points)->spread == Approx(1.0));
  points.row(2) << 2.0, 2.0, 2.0, 2.0;
  CHECK(fit_rigid(points, points)->spread == Approx(1.0));
}

TEST_CASE("a point of weight n counts as n points", "[matching]") {
  std::mt19937 random(46);
  const Eigen::Matrix3Xd source = random_points(random, 4), target = random_points(random, 4);
  Eigen::Matrix3Xd sources(3, 6), targets(3, 6);
  sources << source, source.col(3), source.col(3);
  targets << target, target.col(3), target.col(3);
  const auto weighted = fit_rigid(target, source, Eigen::Vector4d(1.0, 1.0, 1.0, 3.0));
  const auto repeated = fit_rigid(targets, sources);
  CHECK(weighted->T_target_source.isApprox(repeated->T_target_source, 1e-9));
  CHECK(weighted->rms == Approx(repeated->rms));
  CHECK(weighted->spread == Approx(repeated->spread));
}

TEST_CASE("no points give no fit, coincident ones a translation", "[matching]") {
  CHECK_FALSE(fit_rigid(Eigen::Matrix3Xd(3, 0), Eigen::Matrix3Xd(3, 0)));
  const Eigen::Matrix3Xd source = Eigen::Vector3d(1, 2, 3).replicate(1, 3);
  const Eigen::Matrix3Xd target = Eigen::Vector3d(4, 4, 4).replicate(1, 3);
  const auto fit = fit_rigid(target, source);
  REQUIRE(fit);
  CHECK(is_rotation(fit->T_target_source.linear()));
  CHECK(transformed(fit->T_target_source, source).isApprox(target));
  CHECK(fit->spread == 0.0);
}
