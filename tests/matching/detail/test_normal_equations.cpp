// SPDX-License-Identifier: MIT
#include <cstddef>
#include <random>
#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include <topobag/matching/detail/normal_equations.hpp>
#include <topobag/matching/point_pair.hpp>

#include "catch.hpp"
#include "matching/layouts.hpp"

using namespace topobag;

TEST_CASE("normal equations by blocks are those of the whole Jacobian", "[matching]") {
  std::mt19937 random(61);
  const double kernel_width = 3.0;
  for (int round = 0; round < 200; ++round) {
    const Eigen::Isometry3d T = random_motion(random, 2.0);
    std::vector<PointPair> pairs;
    Eigen::Matrix<double, 6, 6> H = 1e-6 * Eigen::Matrix<double, 6, 6>::Identity();
    Eigen::Matrix<double, 6, 1> g = Eigen::Matrix<double, 6, 1>::Zero();
    for (int i = 0; i < 3 + round % 8; ++i) {
      const PointPair pair{random_motion(random, 3.0).translation(),
                           random_motion(random, 3.0).translation(), random_covariance(random, 0.3),
                           random_covariance(random, 0.3)};
      pairs.push_back(pair);
      const Eigen::Vector3d moved = T * pair.source;
      Eigen::Matrix<double, 3, 6> J;
      J << Eigen::Matrix3d::Identity(), Eigen::Vector3d::UnitX().cross(moved),
          Eigen::Vector3d::UnitY().cross(moved), Eigen::Vector3d::UnitZ().cross(moved);
      const double bent = 1.0 + pair.squared_deviation(T) / (kernel_width * kernel_width);
      const Eigen::Matrix3d weight = pair.covariance(T).inverse() / (bent * bent);
      H += J.transpose() * weight * J;
      g += J.transpose() * weight * pair.residual(T);
    }
    const detail::NormalEquations<double> equations(T, pairs, kernel_width);
    const auto solution = equations.solution();
    Eigen::Matrix<double, 6, 1> xi;
    xi << solution.translation, solution.rotation;
    INFO("round " << round);
    CHECK(xi.isApprox(H.llt().solve(g), 1e-8));
    CHECK((equations.covariance() * H).isIdentity(1e-8));
    CHECK(equations.covariance().isApprox(equations.covariance().transpose(), 1e-12));
  }
}
