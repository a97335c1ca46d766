// SPDX-License-Identifier: MIT
#include <cmath>
#include <random>

#include <topobag/matching/point_pair.hpp>

#include "catch.hpp"
#include "random_graphs.hpp"

using namespace topobag;

TEST_CASE("a pair's deviation is its residual in standard deviations", "[matching]") {
  Eigen::Matrix3d target = Eigen::Vector3d(0.01, 0.04, 0.09).asDiagonal();
  const PointPair pair{{0.1, 0.4, 0.9}, {0, 0, 0}, target, Eigen::Matrix3d::Zero()};
  const Eigen::Isometry3d identity = Eigen::Isometry3d::Identity();
  CHECK(pair.squared_deviation(identity) == Approx(1.0 + 4.0 + 9.0));
  // A quarter turn about z carries the source's x deviation to y.
  const Eigen::Isometry3d turn(Eigen::AngleAxisd(std::acos(0.0), Eigen::Vector3d::UnitZ()));
  const PointPair turned{{0, 0, 0}, {0, 0, 0}, Eigen::Matrix3d::Zero(), target};
  const Eigen::Matrix3d expected = Eigen::Vector3d(0.04, 0.01, 0.09).asDiagonal();
  CHECK(turned.covariance(turn).isApprox(expected));
}

TEST_CASE("a pair of nodes has their positions and the noise model's covariances", "[matching]") {
  std::mt19937 random(1);
  const auto graph = random_graph(random, 2);
  const SemanticNode<>&there = graph.nodes()[0], &here = graph.nodes()[1];
  const PointPair pair = point_pair(there, here);
  CHECK(pair.target == *there.position);
  CHECK(pair.source == *here.position);
  CHECK(pair.target_covariance == position_covariance(there));
  CHECK(pair.source_covariance == position_covariance(here));
}
