// SPDX-License-Identifier: MIT
// Where another place that fits about as well puts the query.
#include <random>

#include <topobag/recognition/relocalizer.hpp>

#include "catch.hpp"
#include "synthetic_room.hpp"

using namespace topobag;

TEST_CASE("a rival puts the query in its own place of the world", "[recognition]") {
  const TopologyGraph<> seen = SyntheticRoom(6, 9, 5).seen_from(Eigen::Isometry3d::Identity());
  Relocalizer<> relocalizer;
  relocalizer.map().add(KeyframeId{1}, seen, standing_at(Eigen::Isometry3d::Identity()));
  relocalizer.map().add(KeyframeId{2}, seen,
                        standing_at(Eigen::Isometry3d(Eigen::Translation3d(50, 0, 0))));
  const Recognition found = relocalizer.localize(seen);
  REQUIRE(found.candidates.size() == 2);
  REQUIRE(found.candidates[0].rival);
  const RivalPlace& rival = *found.candidates[0].rival;
  CHECK(rival.id == found.candidates[1].id);
  CHECK(rival.T_candidate_query.isApprox(Eigen::Isometry3d::Identity(), 1e-6));
  REQUIRE(rival.T_world_query);
  const double x = rival.id == KeyframeId{2} ? 50.0 : 0.0;
  CHECK((rival.T_world_query->translation() - Eigen::Vector3d(x, 0, 0)).norm() < 1e-6);
}

TEST_CASE("without poses a rival puts the query into its key frame's camera frame",
          "[recognition]") {
  const SyntheticRoom room(6, 9, 5);
  std::mt19937 random(3);
  const Eigen::Isometry3d T_room_first = random_camera(random),
                          T_room_query = random_camera(random);
  Relocalizer<> relocalizer;
  relocalizer.map().add(KeyframeId{1}, room.seen_from(T_room_first));
  EntryInfo other_session;
  other_session.session = 1;
  relocalizer.map().add(KeyframeId{2}, room.seen_from(T_room_first), other_session);
  const Recognition found = relocalizer.localize(room.seen_from(T_room_query));
  CHECK_FALSE(found);
  REQUIRE_FALSE(found.candidates.empty());
  REQUIRE(found.candidates.front().rival);
  const RivalPlace& rival = *found.candidates.front().rival;
  CHECK(rival.T_candidate_query.isApprox(T_room_first.inverse() * T_room_query, 1e-3));
  CHECK_FALSE(rival.T_world_query);
}
