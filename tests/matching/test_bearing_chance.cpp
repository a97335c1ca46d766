// SPDX-License-Identifier: MIT
#include <cmath>
#include <random>
#include <vector>

#include <topobag/matching/bearing_chance.hpp>

#include "catch.hpp"

using namespace topobag;

namespace {

/// Bearings on a grid of 0.2 rad, each exactly where its object is.
std::vector<BearingPair> exact_bearings(std::size_t count, double deviation) {
  std::vector<BearingPair> pairs;
  for (std::size_t i = 0; i < count; ++i) {
    BearingPair pair;
    const double x = 0.2 * static_cast<double>(i % 3), y = 0.2 * static_cast<double>(i / 3);
    pair.direction = Eigen::Vector3d(x, y, 1.0).normalized();
    pair.covariance = deviation * deviation * Eigen::Matrix2d::Identity();
    pairs.push_back(pair);
  }
  return pairs;
}

RefinedPose pose_with(double deviation) {
  return {Eigen::Isometry3d::Identity(),
          deviation * deviation * Eigen::Matrix<double, 6, 6>::Identity()};
}

}  // namespace

TEST_CASE("a bearing is worth its gate's share of the rectangle", "[bearing_chance]") {
  BearingChance chance;
  const double deviation = 0.02, pi = 3.141592653589793;
  std::vector<BearingPair> pairs = exact_bearings(9, deviation);
  const double before = chance.log10_bayes_factor(pairs, 0, pose_with(0.05));
  pairs.push_back(pairs[4]);  // in the middle: the rectangle shrinks a little
  const double after = chance.log10_bayes_factor(pairs, 0, pose_with(0.05));
  const double gate = 2.0 * pi * deviation * deviation;
  const double shrunk = 9.0 * std::log10(chance.solid_angle(pairs) /
                                         chance.solid_angle(exact_bearings(9, deviation)));
  CHECK(after - before - shrunk ==
        Approx(std::log10((1.0 - chance.unmapped) * chance.solid_angle(pairs) / gate)));
}

TEST_CASE("what a bearing might have been of, and what is of nothing, costs", "[bearing_chance]") {
  const BearingChance chance;
  std::vector<BearingPair> pairs = exact_bearings(5, 0.02);
  const double plain = chance.log10_bayes_factor(pairs, 0, pose_with(0.05));
  CHECK(chance.log10_bayes_factor(pairs, 2, pose_with(0.05)) ==
        Approx(plain + 2.0 * std::log10(chance.unmapped)));
  pairs[1].choices = 10;
  CHECK(chance.log10_bayes_factor(pairs, 0, pose_with(0.05)) == Approx(plain - 1.0));
  RefinedPose far = pose_with(0.05);
  far.T_target_source.translation().x() = 3.0;
  CHECK(chance.log10_bayes_factor(pairs, 0, far) < plain - 1.0);
}

TEST_CASE("chance gains nothing from sizes on average", "[bearing_chance]") {
  // Markov's inequality asks for a mean of at most 1 of the factor under chance.
  const BearingChance chance;
  std::mt19937 random(4);
  std::normal_distribution<double> ratio(0.0, chance.chance_deviation);
  double sum = 0.0;
  const int rounds = 100000;
  for (int i = 0; i < rounds; ++i) sum += std::exp(chance.log_size_factor(ratio(random)));
  CHECK(sum / rounds < 1.02);
  CHECK(chance.log_size_factor(0.0) > 0.5);
  CHECK(chance.log_size_factor(1.0) < -1.0);
}

TEST_CASE("bearings strewn by chance are rarely as good as three decades", "[bearing_chance]") {
  // The pose is kept, and each bearing falls anywhere on the rectangle: at most one in a thousand
  // may reach a factor of 10³.
  const BearingChance chance;
  std::mt19937 random(9);
  std::uniform_real_distribution<double> at(-0.2, 0.2);
  std::size_t reached = 0;
  const double deviation = 0.02;
  for (int round = 0; round < 20000; ++round) {
    auto pairs = exact_bearings(9, deviation);
    for (BearingPair& pair : pairs) {
      const double x = at(random), y = at(random);
      pair.squared_deviation = (x * x + y * y) / (deviation * deviation);
    }
    if (chance.log10_bayes_factor(pairs, 0, pose_with(0.05)) >= 3.0) ++reached;
  }
  CHECK(reached <= 20);
}
