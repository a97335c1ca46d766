// SPDX-License-Identifier: MIT
#include <cmath>

#include <topobag/matching/viewpoint_prior.hpp>

#include "catch.hpp"

using namespace topobag;

namespace {

const double pi = std::acos(-1.0);

double odds_at(const ViewpointPrior& prior, double angle) {
  return prior.log10_odds(
      Eigen::AngleAxisd(angle, Eigen::Vector3d(1, 2, -1).normalized()).toRotationMatrix());
}

}  // namespace

TEST_CASE("the odds of the same view, worked out by hand", "[matching]") {
  const ViewpointPrior prior{0.7, 0.5};
  // 8π² / (2π · 0.25)^1.5 = 40.106; exp(−½ · 2²) = 0.13534 at 1 rad.
  CHECK(odds_at(prior, 0.0) == Approx(std::log10(0.7 * 40.106 + 0.3)).epsilon(1e-4));
  CHECK(odds_at(prior, 1.0) == Approx(std::log10(0.7 * 40.106 * 0.13534 + 0.3)).epsilon(1e-4));
  CHECK(odds_at(prior, pi) == Approx(std::log10(0.3)).epsilon(1e-4));
}

TEST_CASE("the more a pose turns the view, the less likely it is a revisit", "[matching]") {
  for (double angle = 0.1; angle < 2.0; angle += 0.1) {
    CHECK(odds_at({}, angle) < odds_at({}, angle - 0.1));
  }
}

TEST_CASE("under chance the mean odds of a view are one", "[matching]") {
  // The angle of a uniform rotation has the density (1 − cos θ) / π. A narrow Gaussian, for the
  // prior takes the tangent space for the group.
  const ViewpointPrior prior{0.7, 0.2};
  double mean = 0.0;
  const double step = 1e-3;
  for (double angle = 0.5 * step; angle < pi; angle += step) {
    mean += step * (1.0 - std::cos(angle)) / pi * std::pow(10.0, odds_at(prior, angle));
  }
  CHECK(mean == Approx(1.0).epsilon(0.02));
}

TEST_CASE("without a share there is no prior", "[matching]") {
  CHECK(odds_at({0.0, 0.5}, 0.0) == 0.0);
  CHECK(odds_at({0.0, 0.5}, 2.0) == 0.0);
}
