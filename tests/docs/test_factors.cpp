// SPDX-License-Identifier: MIT
// What the page factors.md shows.
#include <random>
#include <sstream>

#include <topobag/evaluation/g2o_text.hpp>
#include <topobag/recognition/relocalizer.hpp>

#include "catch.hpp"
#include "recognition/synthetic_room.hpp"

using namespace topobag;

TEST_CASE("a match becomes a factor of GTSAM's and g2o's", "[docs]") {
  std::mt19937 random(1);
  const Eigen::Isometry3d T_world_first = random_camera(random);
  const Eigen::Isometry3d T_world_second = random_camera(random);
  const SyntheticRoom room(1, 10, 8);
  Relocalizer<> relocalizer;
  relocalizer.map().add(KeyframeId{1}, room.seen_from(T_world_first), standing_at(T_world_first));
  const Recognition found = relocalizer.localize(room.seen_from(T_world_second));
  REQUIRE(found);

  const PoseWithCovariance<> match = found.accepted->pose->with_covariance();
  const GtsamPose between = match.as<GtsamPose>();
  const Eigen::Isometry3d error = between.T.inverse() * T_world_first.inverse() * T_world_second;
  CHECK(error.translation().norm() < 0.05);
  const PoseWithCovariance<> T_query_candidate = match.inverse();
  CHECK((T_query_candidate.T * match.T).isApprox(Eigen::Isometry3d::Identity(), 1e-9));

  const Eigen::Isometry3d pose_of_back_end = T_world_first;
  const Eigen::Matrix<double, 6, 6> marginal_covariance =
      1e-4 * Eigen::Matrix<double, 6, 6>::Identity();
  const auto T_world_query = relocalizer.T_world_query(found);
  const GtsamPose T_world_candidate{pose_of_back_end, marginal_covariance};
  const auto less_certain =
      relocalizer.T_world_query(found, T_world_candidate.as<PoseWithCovariance<>>());
  REQUIRE(T_world_query);
  REQUIRE(less_certain);
  CHECK(less_certain->T.matrix() == T_world_query->T.matrix());
  CHECK(less_certain->covariance.trace() > T_world_query->covariance.trace() + 5e-4);

  std::ostringstream file;
  write_g2o_vertex(file, KeyframeId{1}, T_world_first);
  write_g2o_vertex(file, KeyframeId{2}, T_world_second);
  write_g2o_edge(file, KeyframeId{1}, KeyframeId{2}, match);
  write_g2o_edge(file, KeyframeId{1}, KeyframeId{2}, match, G2oRotation::rotation_vector);
  std::istringstream lines(file.str());
  std::size_t count = 0;
  for (std::string line; std::getline(lines, line);) ++count;
  CHECK(count == 4);
}
