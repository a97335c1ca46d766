// SPDX-License-Identifier: MIT
#include <topobag/evaluation/place_truth.hpp>

#include "catch.hpp"
#include "evaluation/random_poses.hpp"

using namespace topobag;
using topobag_tests::planar_pose;

TEST_CASE("within one trajectory neighbours and the key frame itself are not asked",
          "[evaluation]") {
  Trajectory places;
  for (int i = 0; i < 10; ++i) places.push_back({0.5 * i, planar_pose(0, 0, 0)});
  PlaceProtocol protocol;
  protocol.distance_m = 1.0;
  const auto excluded = [&](std::size_t query, std::size_t candidate) {
    return PlaceTruth(protocol, places).relation(query, candidate) == PairRelation::excluded;
  };
  CHECK(excluded(4, 4));
  CHECK_FALSE(excluded(4, 5));
  protocol.exclude_frames = 2;
  CHECK(excluded(4, 5));
  CHECK(excluded(5, 4));
  CHECK_FALSE(excluded(4, 6));
  protocol.exclude_seconds = 1.5;
  CHECK(excluded(6, 4));
  CHECK_FALSE(excluded(7, 4));  // exactly 1.5 s: not closer
  CHECK_FALSE(excluded(4, 7));
  protocol.past_only = true;
  CHECK(excluded(4, 7));
  CHECK_FALSE(excluded(7, 4));
}

TEST_CASE("the relation follows from the poses", "[evaluation]") {
  std::mt19937 random(10);
  const Trajectory queries = topobag_tests::random_trajectory(random, 30);
  const Trajectory map = topobag_tests::random_trajectory(random, 40);
  PlaceProtocol protocol;
  protocol.distance_m = 4.0;
  protocol.angle_deg = 90.0;
  protocol.negative_distance_m = 6.0;
  protocol.negative_angle_deg = 120.0;
  const PlaceTruth truth(protocol, queries, map);
  REQUIRE(truth.num_queries() == 30);
  REQUIRE(truth.num_candidates() == 40);
  int found[3] = {0, 0, 0};
  for (std::size_t q = 0; q < 30; ++q) {
    for (std::size_t c = 0; c < 40; ++c) {
      const Eigen::Isometry3d a = map[c].T_world_body;
      const Eigen::Isometry3d b = queries[q].T_world_body;
      const double distance = (a.translation() - b.translation()).norm();
      const double cosine = ((a.linear().transpose() * b.linear()).trace() - 1.0) / 2.0;
      const double angle = std::acos(std::min(1.0, std::max(-1.0, cosine))) * degrees_per_radian;
      const PairRelation expected = distance <= 4.0 && angle <= 90.0    ? PairRelation::positive
                                    : distance >= 6.0 || angle >= 120.0 ? PairRelation::negative
                                                                        : PairRelation::ignored;
      CHECK(truth.relation(q, c) == expected);
      ++found[static_cast<int>(expected)];
      CHECK(truth.T_candidate_query(q, c).isApprox(a.inverse() * b));
    }
  }
  CHECK(found[0] > 20);
  CHECK(found[1] > 20);
  CHECK(found[2] > 20);
}

TEST_CASE("the relation by covisibility", "[evaluation]") {
  PlaceProtocol protocol;
  protocol.covisibility = 0.5;
  protocol.frustum = DepthFrustum{{517.3, 516.5, 318.6, 255.3, 640, 480}, 0.5, 4.0};
  const PlaceTruth truth(
      protocol,
      {{0.0, planar_pose(0, 0, 0)}, {1.0, planar_pose(0.1, 0, 0)}, {2.0, planar_pose(9, 0, 0)}});
  CHECK(truth.relation(0, 1) == PairRelation::positive);
  CHECK(truth.relation(0, 2) == PairRelation::negative);
}

TEST_CASE("exclusions are about one trajectory", "[evaluation]") {
  PlaceProtocol protocol;
  protocol.distance_m = 1.0;
  CHECK_NOTHROW(PlaceTruth(protocol, {}, {}));
  protocol.exclude_frames = 3;
  CHECK_THROWS_AS(PlaceTruth(protocol, {}, {}), InvalidValue);
  CHECK_THROWS_AS(PlaceTruth(PlaceProtocol{}, Trajectory{}), InvalidValue);
}

TEST_CASE("poses kept as float say nearly the same", "[evaluation]") {
  std::mt19937 random(11);
  const Trajectory places = topobag_tests::random_trajectory(random, 10);
  PlaceProtocol protocol;
  protocol.covisibility = 0.3;
  protocol.frustum = DepthFrustum{{525.0, 525.0, 319.5, 239.5, 640, 480}, 0.4, 4.0};
  const PlaceTruth truth(protocol, places);
  const BasicPlaceTruth<float> kept(protocol, places);
  for (std::size_t i = 1; i < 10; ++i) {
    CHECK(kept.relation(0, i) == truth.relation(0, i));
    const PoseError error = pose_error(truth.T_candidate_query(0, i),
                                       kept.T_candidate_query(0, i).cast<double>());
    CHECK(error.translation_m < 1e-4);
    CHECK(error.rotation_deg < 1e-3);
  }
}
