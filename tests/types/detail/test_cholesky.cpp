// SPDX-License-Identifier: MIT
#include <cmath>
#include <random>

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include <topobag/types/detail/cholesky.hpp>

#include "catch.hpp"

namespace {

using Covariance = Eigen::Matrix<double, 6, 6>;

Covariance sixfold_covariance(std::mt19937& random) {
  std::normal_distribution<double> normal;
  const Covariance root = Covariance::NullaryExpr([&] { return normal(random); });
  return root * root.transpose() + 1e-3 * Covariance::Identity();
}

}  // namespace

TEST_CASE("the factor of a covariance multiplies to it", "[cholesky]") {
  std::mt19937 random(5);
  for (int round = 0; round < 1000; ++round) {
    const Covariance sigma = sixfold_covariance(random);
    const Covariance L = topobag::detail::cholesky(sigma);
    CHECK(L.isLowerTriangular());
    CHECK((L * L.transpose()).isApprox(sigma, 1e-10));
    CHECK(topobag::detail::log_root_determinant(sigma) ==
          Approx(0.5 * std::log(sigma.determinant())).epsilon(1e-6).margin(1e-6));
    const Covariance inverse = topobag::detail::inverse_covariance(sigma);
    CHECK((inverse * sigma).isApprox(Covariance::Identity(), 1e-7));
    CHECK(inverse == inverse.transpose());
    const Eigen::Matrix<double, 6, 1> xi = Eigen::Matrix<double, 6, 1>::Random();
    CHECK(topobag::detail::squared_mahalanobis(sigma, xi) ==
          Approx(xi.dot(sigma.ldlt().solve(xi))).epsilon(1e-6));
  }
}

TEST_CASE("what is no covariance has no finite determinant, inverse or distance", "[cholesky]") {
  Covariance sigma = Covariance::Identity();
  sigma(2, 2) = -1.0;
  CHECK_FALSE(std::isfinite(topobag::detail::log_root_determinant(sigma)));
  CHECK_FALSE(topobag::detail::inverse_covariance(sigma).allFinite());
  CHECK_FALSE(topobag::detail::inverse_covariance(Covariance::Zero().eval()).allFinite());
  CHECK_FALSE(std::isfinite(
      topobag::detail::squared_mahalanobis(sigma, Eigen::Matrix<double, 6, 1>::Ones())));
}
