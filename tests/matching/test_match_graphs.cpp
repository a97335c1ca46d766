// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

#include <Eigen/Geometry>

#include <topobag/matching/match_graphs.hpp>

#include "catch.hpp"
#include "matching/layouts.hpp"

using namespace topobag;

TEST_CASE("a planted pose is found in noise and clutter", "[matching]") {
  std::mt19937 random(91);
  for (int round = 0; round < 100; ++round) {
    const double deviation = 0.02;
    const TopologyGraph<> place = noisy_graph(random, 8, 4, deviation);
    const Eigen::Isometry3d T_candidate_query = random_motion(random, 1.0);
    auto candidate = jittered(random, place, 1.0).nodes();
    auto query = moved(jittered(random, place, 1.0), T_candidate_query.inverse()).nodes();
    for (auto* nodes : {&candidate, &query}) {
      const TopologyGraph<> clutter = noisy_graph(random, 4, 4, deviation);
      nodes->insert(nodes->end(), clutter.nodes().begin(), clutter.nodes().end());
    }
    const GraphMatch match = match_graphs(TopologyGraph<>(candidate), TopologyGraph<>(query));
    INFO("round " << round);
    REQUIRE_FALSE(match.poses.empty());
    CHECK(match.complete);
    const RelativePose& best = match.poses.front();
    CHECK((best.T_candidate_query.inverse() * T_candidate_query).translation().norm() < 0.2);
    CHECK(angle_between(best.T_candidate_query, T_candidate_query) < 0.05);
    CHECK(best.inliers.size() >= 6);
    CHECK(best.support() > 1.0);
    CHECK_FALSE(best.degenerate);
  }
}

TEST_CASE("what comes with a pose fits it", "[matching]") {
  std::mt19937 random(92);
  for (int round = 0; round < 50; ++round) {
    const TopologyGraph<> candidate = noisy_graph(random, 10, 3, 0.03);
    const TopologyGraph<> query = jittered(random, candidate, 1.0);
    const GraphMatch match = match_graphs(candidate, query);
    REQUIRE_FALSE(match.poses.empty());
    for (std::size_t i = 0; i < match.poses.size(); ++i) {
      const RelativePose& pose = match.poses[i];
      CHECK(pose.T_candidate_query.linear().determinant() == Approx(1.0));
      CHECK(pose.covariance.allFinite());
      CHECK(std::is_sorted(pose.inliers.begin(), pose.inliers.end()));
      std::vector<bool> taken(candidate.size(), false);
      double squares = 0.0;
      for (const Correspondence& pair : pose.inliers) {
        CHECK(candidate.node(pair.candidate).label == query.node(pair.query).label);
        CHECK_FALSE(taken[value(pair.candidate)]);
        taken[value(pair.candidate)] = true;
        squares += (*candidate.node(pair.candidate).position -
                    pose.T_candidate_query * *query.node(pair.query).position)
                       .squaredNorm();
      }
      CHECK(pose.rms == Approx(std::sqrt(squares / static_cast<double>(pose.inliers.size()))));
      if (i > 0) CHECK(pose.score() <= match.poses[i - 1].score());
    }
  }
}

TEST_CASE("a rigid motion of the query moves the pose and leaves its support", "[matching]") {
  std::mt19937 random(101);
  for (int round = 0; round < 100; ++round) {
    // Elsewhere a camera would see the objects from another side, unless they are points; turned in
    // its place it does not.
    const bool points = round % 2 == 0;
    auto nodes = noisy_graph(random, 9, 3, 0.03).nodes();
    for (auto& node : nodes) {
      if (points) node.size.setZero();
    }
    const TopologyGraph<> candidate(nodes);
    const TopologyGraph<> query = jittered(random, candidate, 1.0);
    const Eigen::Isometry3d T = random_motion(random, points ? 1.0 : 0.0);
    const RelativePose still = match_graphs(candidate, query).poses.at(0);
    bool found = false;
    for (const RelativePose& pose : match_graphs(candidate, moved(query, T)).poses) {
      found |= (pose.T_candidate_query * T).isApprox(still.T_candidate_query, 1e-6) &&
               std::abs(pose.support() - still.support()) < 1e-6;
    }
    CAPTURE(round);
    CHECK(found);
  }
}

TEST_CASE("a mirror image is not matched by a reflection", "[matching]") {
  std::mt19937 random(93);
  for (int round = 0; round < 50; ++round) {
    const TopologyGraph<> place = noisy_graph(random, 8, 8, 0.01);
    const GraphMatch image = match_graphs(place, mirrored(place));
    const GraphMatch itself = match_graphs(place, place);
    REQUIRE_FALSE(itself.poses.empty());
    for (const RelativePose& pose : image.poses) {
      CHECK(pose.T_candidate_query.linear().determinant() == Approx(1.0));
      CHECK(pose.inliers.size() < itself.poses.front().inliers.size());
      CHECK(pose.support() < itself.poses.front().support() - 1.0);
    }
  }
}

TEST_CASE("the order of the nodes does not matter", "[matching]") {
  std::mt19937 random(96);
  for (int round = 0; round < 100; ++round) {
    const TopologyGraph<> candidate = noisy_graph(random, 9, 3, 0.03);
    const TopologyGraph<> query =
        moved(jittered(random, candidate, 1.0), random_motion(random, 1.0));
    const GraphMatch match = match_graphs(candidate, query);
    const GraphMatch again = match_graphs(permuted(candidate, random_order(random, 9)),
                                          permuted(query, random_order(random, 9)));
    INFO("round " << round);
    REQUIRE_FALSE(match.poses.empty());
    REQUIRE_FALSE(again.poses.empty());
    const RelativePose &a = match.poses.front(), &b = again.poses.front();
    CHECK((a.T_candidate_query.matrix() - b.T_candidate_query.matrix()).cwiseAbs().maxCoeff() <
          1e-9);
    CHECK(std::abs(a.score() - b.score()) < 1e-9);
  }
}

TEST_CASE("matching twice gives the same bits", "[matching]") {
  std::mt19937 random(97);
  const TopologyGraph<> candidate = noisy_graph(random, 12, 2), query = noisy_graph(random, 12, 2);
  const GraphMatch a = match_graphs(candidate, query), b = match_graphs(candidate, query);
  REQUIRE(a.poses.size() == b.poses.size());
  for (std::size_t i = 0; i < a.poses.size(); ++i) {
    CHECK(a.poses[i].T_candidate_query.matrix() == b.poses[i].T_candidate_query.matrix());
    CHECK(a.poses[i].score() == b.poses[i].score());
    CHECK(a.poses[i].inliers == b.poses[i].inliers);
  }
}

TEST_CASE("fewer than three objects give no pose", "[matching]") {
  std::mt19937 random(98);
  const TopologyGraph<> empty, many = noisy_graph(random, 8, 1);
  for (std::size_t count = 0; count < 3; ++count) {
    const std::vector<SemanticNode<>> few(
        many.nodes().begin(), many.nodes().begin() + static_cast<std::ptrdiff_t>(count));
    const TopologyGraph<> small(few);
    CHECK(match_graphs(small, many).poses.empty());
    CHECK(match_graphs(many, small).poses.empty());
  }
  CHECK(match_graphs(empty, empty).complete);
}

TEST_CASE("a search that ends with its budget says so", "[matching]") {
  MatchOptions options;
  options.max_steps = 10;
  const TopologyGraph<> grid = grid_graph(16, 4, 0.5);
  CHECK_FALSE(match_graphs(grid, grid, options).complete);
}

TEST_CASE("nodes whose covariance is not modelled are matched with the default noise",
          "[matching][regression]") {
  std::mt19937 random(99);
  for (int round = 0; round < 20; ++round) {
    const TopologyGraph<> candidate(random_nodes(random, 8, 4));
    const Eigen::Isometry3d T = random_motion(random, 1.0);
    const GraphMatch match = match_graphs(candidate, moved(candidate, T.inverse()));
    REQUIRE_FALSE(match.poses.empty());
    CHECK((match.poses.front().T_candidate_query.inverse() * T).translation().norm() < 1e-3);
    CHECK(match.poses.front().covariance.allFinite());
    CHECK(std::isfinite(match.poses.front().score()));
  }
}
