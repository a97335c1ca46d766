// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

#include <Eigen/Geometry>

#include <topobag/matching/refine_pose.hpp>

#include "catch.hpp"
#include "matching/layouts.hpp"

using namespace topobag;

namespace {

Eigen::Vector3d normal_vector(std::mt19937& random) {
  std::normal_distribution<double> normal;
  const double x = normal(random), y = normal(random), z = normal(random);
  return {x, y, z};
}

Eigen::Vector3d noise(std::mt19937& random, const Eigen::Matrix3d& covariance) {
  return covariance.llt().matrixL() * normal_vector(random);
}

/// Objects about a metre apart, each seen from two cameras with noise of `scale` m.
std::vector<PointPair> seen_twice(std::mt19937& random, std::size_t count,
                                  const Eigen::Isometry3d& T_target_source, double scale,
                                  bool with_noise = true) {
  std::vector<PointPair> pairs;
  for (std::size_t i = 0; i < count; ++i) {
    const Eigen::Vector3d source = normal_vector(random);
    PointPair pair{T_target_source * source, source, random_covariance(random, scale),
                   random_covariance(random, scale)};
    if (with_noise) {
      pair.target += noise(random, pair.target_covariance);
      pair.source += noise(random, pair.source_covariance);
    }
    pairs.push_back(pair);
  }
  return pairs;
}

/// A start a few degrees and centimetres off.
Eigen::Isometry3d off(std::mt19937& random, const Eigen::Isometry3d& T) {
  const Eigen::Vector3d axis = normal_vector(random).normalized();
  return Eigen::Translation3d(0.05 * normal_vector(random)) * Eigen::AngleAxisd(0.05, axis) * T;
}

/// ξ with T_true = Exp(ξ) · T.
Eigen::Matrix<double, 6, 1> error_of(const Eigen::Isometry3d& T, const Eigen::Isometry3d& T_true) {
  const Eigen::Isometry3d between = T_true * T.inverse();
  const Eigen::AngleAxisd turn(between.linear());
  Eigen::Matrix<double, 6, 1> xi;
  xi << between.translation(), turn.angle() * turn.axis();
  return xi;
}

double cost(const Eigen::Isometry3d& T, const std::vector<PointPair>& pairs) {
  double sum = 0.0;
  for (const PointPair& pair : pairs) sum += pair.squared_deviation(T);
  return sum;
}

RefineOptions least_squares() {
  RefineOptions options;
  options.iterations = 20;
  options.kernel_width = 1e4;
  options.tolerance = 1e-12;
  return options;
}

}  // namespace

TEST_CASE("refinement recovers a planted pose from exact pairs", "[matching]") {
  std::mt19937 random(51);
  for (int round = 0; round < 200; ++round) {
    const Eigen::Isometry3d T = random_motion(random, 2.0);
    const auto pairs = seen_twice(random, 4, T, 0.05, false);
    RefineOptions options;
    options.iterations = 30;
    const RefinedPose refined = refine_pose(off(random, T), pairs, options);
    CHECK(error_of(refined.T_target_source, T).norm() < 1e-6);
    CHECK(refined.T_target_source.linear().determinant() == Approx(1.0));
  }
}

TEST_CASE("the refined pose is the least-squares one under a wide kernel", "[matching]") {
  std::mt19937 random(52);
  for (int round = 0; round < 30; ++round) {
    const Eigen::Isometry3d T = random_motion(random, 2.0);
    auto pairs = seen_twice(random, 6, T, 0.05);
    // A source covariance would turn with the pose and enter the cost.
    for (PointPair& pair : pairs) pair.source_covariance = 0.0025 * Eigen::Matrix3d::Identity();
    const Eigen::Isometry3d best = refine_pose(T, pairs, least_squares()).T_target_source;
    const double least = cost(best, pairs);
    for (int trial = 0; trial < 40; ++trial) {
      const double length = trial % 2 == 0 ? 1e-3 : 0.03;
      const Eigen::Vector3d axis = normal_vector(random).normalized();
      const Eigen::Isometry3d other = Eigen::Translation3d(length * normal_vector(random)) *
                                      Eigen::AngleAxisd(length, axis) * best;
      CHECK(cost(other, pairs) >= least - 1e-9);
    }
  }
}

TEST_CASE("the covariance of the pose is consistent: mean NEES of six", "[matching]") {
  std::mt19937 random(53);
  const std::size_t matches = 20000;
  double sum = 0.0;
  for (std::size_t i = 0; i < matches; ++i) {
    const Eigen::Isometry3d T = random_motion(random, 2.0);
    // Places differ by about 1.4 m, 35 times the noise.
    const auto pairs = seen_twice(random, 8, T, 0.04);
    const RefinedPose refined = refine_pose(T, pairs, least_squares());
    const auto xi = error_of(refined.T_target_source, T);
    sum += xi.dot(refined.covariance.ldlt().solve(xi));
  }
  const double nees = sum / static_cast<double>(matches);
  CAPTURE(nees);
  CHECK(nees > 5.5);
  CHECK(nees < 6.5);
}

TEST_CASE("the covariance of the pose is that of repeated measurements", "[matching]") {
  std::mt19937 random(54);
  const Eigen::Isometry3d T = random_motion(random, 1.0);
  const auto exact = seen_twice(random, 6, T, 0.02, false);
  const auto expected = refine_pose(T, exact, least_squares()).covariance;
  const int trials = 3000;
  Eigen::Matrix<double, 6, 6> measured = Eigen::Matrix<double, 6, 6>::Zero();
  for (int trial = 0; trial < trials; ++trial) {
    auto pairs = exact;
    for (PointPair& pair : pairs) {
      pair.target += noise(random, pair.target_covariance);
      pair.source += noise(random, pair.source_covariance);
    }
    const auto xi = error_of(refine_pose(T, pairs, least_squares()).T_target_source, T);
    measured += xi * xi.transpose() / trials;
  }
  // In units of the expected deviations, so that all entries are of order one.
  const Eigen::Matrix<double, 6, 6> L = expected.llt().matrixL();
  const Eigen::Matrix<double, 6, 6> whitened =
      L.inverse() * measured * L.inverse().transpose() - Eigen::Matrix<double, 6, 6>::Identity();
  CHECK(whitened.cwiseAbs().maxCoeff() < 0.15);
}

TEST_CASE("the pose the other way round is about the inverse, and its covariance is carried over",
          "[matching]") {
  // Not to the last digit: a step holds the weights, which turn with one of the two frames.
  std::mt19937 random(56);
  for (int round = 0; round < 50; ++round) {
    const Eigen::Isometry3d T = random_motion(random, 2.0);
    const auto objects = noisy_graph(random, 6, 2);
    const auto seen = jittered(random, moved(objects, T.inverse()), 1.0);
    std::vector<PointPair> pairs, swapped;
    for (std::size_t i = 0; i < objects.size(); ++i) {
      pairs.push_back(point_pair(objects.nodes()[i], seen.nodes()[i]));
      swapped.push_back(point_pair(seen.nodes()[i], objects.nodes()[i]));
    }
    const RefinedPose there = refine_pose(T, pairs);
    const RefinedPose back = refine_pose(T.inverse(), swapped);
    const Eigen::Isometry3d inverse = there.T_target_source.inverse();
    const Eigen::Isometry3d between = back.T_target_source * there.T_target_source;
    const Eigen::AngleAxisd turn(between.linear());
    Eigen::Matrix<double, 6, 1> xi;
    xi << between.translation(), turn.angle() * turn.axis();
    CHECK(xi.dot(back.covariance.ldlt().solve(xi)) < 0.1 * 6.0);
    // T⁻¹ · Exp(−ξ) = Exp(−Ad ξ) · T⁻¹.
    const Eigen::Matrix3d R = inverse.linear();
    const Eigen::Vector3d t = inverse.translation();
    Eigen::Matrix3d cross;
    cross << 0, -t.z(), t.y(), t.z(), 0, -t.x(), -t.y(), t.x(), 0;
    Eigen::Matrix<double, 6, 6> adjoint;
    adjoint << R, cross * R, Eigen::Matrix3d::Zero(), R;
    CHECK(back.covariance.isApprox(adjoint * there.covariance * adjoint.transpose(), 0.2));
    CHECK(Eigen::LLT<Eigen::Matrix<double, 6, 6>>(there.covariance).info() == Eigen::Success);
  }
}

TEST_CASE("one outlier does not drag the pose", "[matching]") {
  std::mt19937 random(55);
  for (int round = 0; round < 100; ++round) {
    const Eigen::Isometry3d T = random_motion(random, 2.0);
    auto pairs = seen_twice(random, 8, T, 0.03, false);
    pairs[0].target += 1.5 * normal_vector(random).normalized();
    const auto robust = error_of(refine_pose(T, pairs).T_target_source, T);
    const auto plain = error_of(refine_pose(T, pairs, least_squares()).T_target_source, T);
    CHECK(robust.norm() < 0.01);
    CHECK(plain.norm() > 10.0 * robust.norm());
  }
}

TEST_CASE("directions that the pairs leave open keep the start", "[matching]") {
  const RefinedPose none = refine_pose(Eigen::Isometry3d(Eigen::Translation3d(1, 2, 3)), {});
  CHECK(none.T_target_source.translation() == Eigen::Vector3d(1, 2, 3));
  CHECK(none.covariance.isApprox(1e6 * Eigen::Matrix<double, 6, 6>::Identity()));

  // Points on the x axis: the turn about it is open.
  std::vector<PointPair> line;
  const Eigen::Matrix3d covariance = 1e-4 * Eigen::Matrix3d::Identity();
  for (const double x : {-1.0, 0.0, 1.0})
    line.push_back({{x, 0, 0}, {x, 0, 0}, covariance, covariance});
  const RefinedPose refined = refine_pose(Eigen::Isometry3d::Identity(), line);
  CHECK(refined.covariance(3, 3) == Approx(1e6));
  CHECK(refined.covariance(4, 4) < 1e-3);
  CHECK(refined.T_target_source.matrix().isIdentity(1e-9));
}
