// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include <Eigen/Core>
#include <Eigen/LU>

#include <topobag/matching/size_prior.hpp>

#include "catch.hpp"

using namespace topobag;

namespace {

constexpr ClassId chair{56};

/// What pairs of squares with these logarithms of the ratio of their sides say.
double said_by(const SizePrior& prior, const std::vector<double>& ratios, ClassId label = chair) {
  SizeEvidence evidence(prior);
  double sum = 0.0;
  for (const double ratio : ratios) {
    const Eigen::Vector2d here(0.3, 0.3);
    sum += evidence.log10_factor(label, Eigen::Vector2d(here * std::exp(ratio)), here);
  }
  return sum;
}

/// log10 of N(x; 0, covariance).
double log10_density(const Eigen::VectorXd& x, const Eigen::MatrixXd& covariance) {
  const double two_pi = 2.0 * std::acos(-1.0);
  const double square = x.dot(covariance.inverse() * x);
  const double volume = (two_pi * covariance).determinant();
  return (-0.5 * square - 0.5 * std::log(volume)) / std::log(10.0);
}

}  // namespace

TEST_CASE("without outliers pair by pair adds up to the odds of all pairs at once", "[matching]") {
  std::mt19937 random(3);
  std::normal_distribution<double> normal(0.0, 0.3);
  for (std::size_t k = 1; k <= 6; ++k) {
    SizePrior prior;
    prior.outliers = 0.0;
    prior.classes[chair] = {{0.2, 0.2}, {0.3, 0.3}};
    std::vector<double> ratios(k);
    for (double& ratio : ratios) ratio = normal(random);
    const auto n = static_cast<Eigen::Index>(k);
    const Eigen::VectorXd x = Eigen::Map<const Eigen::VectorXd>(ratios.data(), n);
    const double same = prior.deviation * prior.deviation;
    const Eigen::MatrixXd one = Eigen::MatrixXd::Identity(n, n);
    const Eigen::MatrixXd apart =
        (2.0 * 0.04 + same) * one + 2.0 * 0.09 * Eigen::MatrixXd::Ones(n, n);
    const double odds = log10_density(x, same * one) - log10_density(x, apart);
    CHECK(said_by(prior, ratios) == Approx(2.0 * odds));  // both sides
  }
}

TEST_CASE("the mean size factor of chance pairs is one: a proper Bayes factor", "[matching]") {
  const SizePrior prior;
  const double variance = 2.0 * 0.14 * 0.14 * 2.0 + prior.deviation * prior.deviation;
  double mean = 0.0;
  const double step = 0.001;
  for (double ratio = -4.0; ratio < 4.0; ratio += step) {
    const double density = std::exp(-0.5 * ratio * ratio / variance) /
                           std::sqrt(2.0 * std::acos(-1.0) * variance);
    const double of_one_side = 0.5 * said_by(prior, {ratio});
    mean += step * density * std::pow(10.0, of_one_side);
  }
  CHECK(mean == Approx(1.0).epsilon(1e-4));
}

TEST_CASE("of many equal chairs only the first is news", "[matching]") {
  SizePrior prior;
  prior.classes[chair] = {{0.0, 0.0}, {0.5, 0.5}};  // each place has one model of chair
  const double first = said_by(prior, {0.0});
  CHECK(first > 0.5);
  CHECK(said_by(prior, std::vector<double>(8, 0.0)) < 2.0 * first);
  // Of another class they do say something again.
  SizeEvidence evidence(prior);
  prior.classes[ClassId{62}] = prior.classes[chair];
  const Eigen::Vector2d size(0.3, 0.3);
  const double of_chair = evidence.log10_factor(chair, size, size);
  CHECK(evidence.log10_factor(ClassId{62}, size, size) == of_chair);
  CHECK(evidence.log10_factor(chair, size, size) < 0.5 * of_chair);
}

TEST_CASE("sizes that differ speak against a match, down to the share of misread ones",
          "[matching]") {
  const SizePrior prior;
  CHECK(said_by(prior, {0.3}) < said_by(prior, {0.0}));
  CHECK(said_by(prior, {0.3}) == Approx(said_by(prior, {-0.3})));
  CHECK(said_by(prior, {4.0}) == Approx(2.0 * std::log10(prior.outliers)));
}

TEST_CASE("an unknown size tells nothing", "[matching]") {
  const SizePrior prior;
  SizeEvidence evidence(prior);
  CHECK(evidence.log10_factor(chair, Eigen::Vector2d(0.0, 0.0), Eigen::Vector2d(0.3, 0.3)) == 0.0);
  CHECK(evidence.log10_factor(chair, Eigen::Vector2d(0.3, 0.3), Eigen::Vector2d(0.0, 0.0)) == 0.0);
}
