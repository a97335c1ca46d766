// SPDX-License-Identifier: MIT
#include <cstddef>
#include <random>

#include <Eigen/Geometry>

#include <topobag/types/detail/cholesky.hpp>
#include <topobag/matching/match_bearings.hpp>

#include "catch.hpp"
#include "recognition/bearings_of.hpp"
#include "recognition/synthetic_room.hpp"

using namespace topobag;

namespace {

/// A graph of a room and the bearings of another camera in it.
struct RoomByBearings {
  RoomByBearings(unsigned seed, std::size_t objects, int classes, double noise) {
    std::mt19937 random(seed);
    const SyntheticRoom room(seed, objects, classes);
    const Eigen::Isometry3d T_room_candidate = random_camera(random);
    const Eigen::Isometry3d T_room_query = random_camera(random);
    candidate = room.seen_from(T_room_candidate);
    seen = room.seen_from(T_room_query);
    query = bearings_of(seen, random, noise);
    T_candidate_query = T_room_candidate.inverse() * T_room_query;
  }

  double error(const RelativePose& pose) const {
    return (pose.T_candidate_query.translation() - T_candidate_query.translation()).norm();
  }

  TopologyGraph<> candidate, seen;
  BearingSighting query;
  Eigen::Isometry3d T_candidate_query;
};

/// With the vertical that both cameras know.
void tell_down(RoomByBearings& room) {
  const Gravity<> query{Eigen::Vector3d(0.1, 0.9, -0.2).normalized(), 0.01};
  room.query.gravity = query;
  const Gravity<> candidate{room.T_candidate_query.linear() * query.down, 0.01};
  room.candidate = TopologyGraph<>(room.candidate.nodes(), {}, {}, candidate);
}

}  // namespace

TEST_CASE("exact bearings of six objects of a room give the pose of its camera",
          "[match_bearings]") {
  for (unsigned seed = 0; seed < 40; ++seed) {
    const RoomByBearings room(seed, 6, 6, 0.0);
    const BearingMatch match = match_bearings(room.candidate, room.query);
    INFO("room " << seed);
    REQUIRE_FALSE(match.poses.empty());
    const RelativePose& pose = match.poses.front();
    CHECK(room.error(pose) < 1e-2);
    CHECK(pose.inliers.size() == 6);
    for (const Correspondence& pair : pose.inliers)
      CHECK(value(pair.candidate) == value(pair.query));
    CHECK(match.triples > 0);
  }
}

TEST_CASE("noisy bearings give a pose as near as its covariance says", "[match_bearings]") {
  double squares = 0.0;
  std::size_t right = 0;
  const unsigned rooms = 60;
  for (unsigned seed = 0; seed < rooms; ++seed) {
    RoomByBearings room(1000 + seed, 10, 8, 0.01);
    std::vector<SemanticNode<>> nodes = room.candidate.nodes();
    for (auto& node : nodes) node.covariance = 1e-6 * Eigen::Matrix3d::Identity();
    room.candidate = TopologyGraph<>(std::move(nodes));
    MatchOptions options;
    BearingOptions bearings;
    bearings.chance.size_deviation = 0.05;
    const BearingMatch match = match_bearings(room.candidate, room.query, options, bearings);
    REQUIRE_FALSE(match.poses.empty());
    const RelativePose& pose = match.poses.front();
    if (room.error(pose) < 0.3 && pose.inliers.size() >= 8) {
      ++right;
      const Eigen::Isometry3d error = room.T_candidate_query * pose.T_candidate_query.inverse();
      const Eigen::AngleAxisd turn(error.linear());
      Eigen::Matrix<double, 6, 1> xi;
      xi << error.translation(), turn.angle() * turn.axis();
      squares += detail::squared_mahalanobis(pose.covariance, xi);
    }
  }
  CHECK(right >= rooms - 3);
  // χ² with six degrees of freedom has a mean of 6; a node's outline adds to what is allowed for.
  const double mean = squares / static_cast<double>(right);
  CHECK(mean > 1.0);
  CHECK(mean < 7.0);
}

TEST_CASE("the bearings of another room are hardly ever believed", "[match_bearings]") {
  std::size_t believed = 0;
  for (unsigned seed = 0; seed < 150; ++seed) {
    const RoomByBearings here(2000 + seed, 8, 4, 0.01), there(3000 + seed, 8, 4, 0.01);
    const BearingMatch match = match_bearings(there.candidate, here.query);
    if (!match.poses.empty() && match.poses.front().score() >= 2.0) ++believed;
  }
  CHECK(believed <= 1);  // at most one in a hundred
}

TEST_CASE("the vertical leaves out poses, and lets three bearings do", "[match_bearings]") {
  for (unsigned seed = 0; seed < 20; ++seed) {
    RoomByBearings room(4000 + seed, 3, 3, 0.0);
    CHECK(match_bearings(room.candidate, room.query).poses.empty());
    tell_down(room);
    const BearingMatch match = match_bearings(room.candidate, room.query);
    INFO("room " << seed);
    bool found = false;
    for (const RelativePose& pose : match.poses) {
      found = found || room.error(pose) < 0.1;
      const Eigen::Vector3d down = pose.T_candidate_query.linear() * room.query.gravity->down;
      CHECK((down - room.candidate.gravity()->down).norm() < 0.1);
    }
    CHECK(found);
  }
}

TEST_CASE("bearings of too few objects, or of other classes, give no pose", "[match_bearings]") {
  RoomByBearings room(1, 8, 8, 0.0);
  CHECK(match_bearings(TopologyGraph<>(), room.query).poses.empty());
  CHECK(match_bearings(room.candidate, BearingSighting()).poses.empty());
  for (Bearing& bearing : room.query.bearings) bearing.label = ClassId{77};
  CHECK(match_bearings(room.candidate, room.query).poses.empty());
}

TEST_CASE("a budget of triples is kept, and told", "[match_bearings]") {
  const RoomByBearings room(5, 12, 2, 0.0);
  BearingOptions bearings;
  bearings.max_triples = 10;
  const BearingMatch match = match_bearings(room.candidate, room.query, {}, bearings);
  CHECK(match.triples == 10);
  CHECK_FALSE(match.complete);
}

TEST_CASE("a pose gives matched bearings their ranges, and no other", "[ranged_bearings]") {
  RoomByBearings room(7, 8, 8, 0.0);
  const BearingMatch match = match_bearings(room.candidate, room.query);
  REQUIRE_FALSE(match.poses.empty());
  RelativePose pose = match.poses.front();
  REQUIRE(pose.inliers.size() >= 4);
  const std::size_t left_out = value(pose.inliers.back().query);
  pose.inliers.pop_back();
  const TopologyGraph<> ranged = ranged_bearings(room.query, room.candidate, pose);
  CHECK_FALSE(ranged.node(node_index(left_out)).position);
  for (const Correspondence& pair : pose.inliers) {
    CHECK((*ranged.node(pair.query).position - *room.seen.node(pair.query).position).norm() < 0.05);
    CHECK((ranged.node(pair.query).size - room.seen.node(pair.query).size).norm() < 0.02);
  }
}
