// SPDX-License-Identifier: MIT
#include <random>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/SVD>

#include <topobag/matching/detail/nearest_rotation.hpp>

#include "catch.hpp"

using namespace topobag;

namespace {

/// Umeyama's, by the decomposition.
Eigen::Matrix3d rotation_by_svd(const Eigen::Matrix3d& C) {
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(C, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Vector3d signs = Eigen::Vector3d::Ones();
  if (svd.matrixU().determinant() * svd.matrixV().determinant() < 0.0) signs.z() = -1.0;
  return svd.matrixU() * signs.asDiagonal() * svd.matrixV().transpose();
}

/// Σ target · sourceᵀ of points that are turned, moved by noise, and flattened along some axes.
Eigen::Matrix3d correlation_of_points(std::mt19937& random, int count, double noise,
                                      const Eigen::Vector3d& extent) {
  std::normal_distribution<double> normal;
  const auto vector = [&] {
    return Eigen::Vector3d(normal(random), normal(random), normal(random));
  };
  const Eigen::Matrix3d R = Eigen::AngleAxisd(normal(random), vector().normalized()).matrix();
  Eigen::Matrix3d C = Eigen::Matrix3d::Zero();
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector3d source = extent.cwiseProduct(vector());
    C += (R * source + noise * vector()) * source.transpose();
  }
  return C;
}

void check_rotation(const Eigen::Matrix3d& R) {
  CHECK((R * R.transpose()).isIdentity(1e-12));
  CHECK(R.determinant() == Approx(1.0));
}

}  // namespace

TEST_CASE("the nearest rotation is the decomposition's", "[matching]") {
  std::mt19937 random(921);
  for (int round = 0; round < 500; ++round) {
    const double flat = round % 3 == 0 ? 0.0 : round % 3 == 1 ? 1e-4 : 1.0;
    const Eigen::Matrix3d C = correlation_of_points(random, 3 + round % 5, 0.1 * (round % 2),
                                                    Eigen::Vector3d(1.0, 0.5, flat));
    const Eigen::Matrix3d R = detail::nearest_rotation(C);
    check_rotation(R);
    const double most = (rotation_by_svd(C).transpose() * C).trace();
    CHECK((R.transpose() * C).trace() == Approx(most).epsilon(1e-12));
  }
}

TEST_CASE("what leaves a rotation open still has one", "[matching]") {
  std::mt19937 random(922);
  for (int round = 0; round < 100; ++round) {
    const Eigen::Matrix3d line =
        correlation_of_points(random, 4, 0.0, Eigen::Vector3d(1.0, 0.0, 0.0));
    const Eigen::Matrix3d R = detail::nearest_rotation(line);
    check_rotation(R);
    // Along the line all that there is is gained.
    CHECK((R.transpose() * line).trace() == Approx(line.norm()).epsilon(1e-9));
  }
  check_rotation(detail::nearest_rotation(Eigen::Matrix3d::Zero()));
  const Eigen::Matrix3d mirror = Eigen::Vector3d(3.0, 2.0, -1.0).asDiagonal();
  CHECK(detail::nearest_rotation(mirror).isIdentity(1e-12));
}
