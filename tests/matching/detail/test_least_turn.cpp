// SPDX-License-Identifier: MIT
#include <random>

#include <Eigen/Geometry>

#include <topobag/matching/detail/least_turn.hpp>

#include "catch.hpp"

namespace {

Eigen::Vector3d direction(std::mt19937& random) {
  std::normal_distribution<double> normal;
  return Eigen::Vector3d(normal(random), normal(random), normal(random)).normalized();
}

}  // namespace

TEST_CASE("the least turn carries one direction onto another by the angle between them",
          "[least_turn]") {
  std::mt19937 random(11);
  for (int round = 0; round < 1000; ++round) {
    const Eigen::Vector3d from = direction(random), to = direction(random);
    const Eigen::Matrix3d R = topobag::detail::least_turn(from, to);
    CHECK((R * R.transpose()).isIdentity(1e-12));
    CHECK(R.determinant() > 0.0);
    CHECK((R * from - to).norm() < 1e-7);
    CHECK(Eigen::AngleAxisd(R).angle() == Approx(std::acos(from.dot(to))).margin(1e-6));
    CHECK(R.isApprox(Eigen::Quaterniond::FromTwoVectors(from, to).toRotationMatrix(), 1e-9));
  }
}

TEST_CASE("the least turn of equal and of opposite directions is one too", "[least_turn]") {
  std::mt19937 random(12);
  for (int round = 0; round < 100; ++round) {
    const Eigen::Vector3d from = direction(random);
    CHECK(topobag::detail::least_turn(from, from).isIdentity(1e-9));
    const Eigen::Matrix3d back = topobag::detail::least_turn(from, -from);
    CHECK((back * from + from).norm() < 1e-7);
    CHECK(back.determinant() == Approx(1.0));
  }
}
