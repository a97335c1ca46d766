// SPDX-License-Identifier: MIT
#include <cstddef>
#include <limits>
#include <random>

#include <Eigen/Geometry>

#include <topobag/matching/match_graphs.hpp>
#include <topobag/matching/match_options.hpp>

#include "catch.hpp"
#include "matching/layouts.hpp"

using namespace topobag;

TEST_CASE("no pair of a pose lies further apart than the options admit", "[matching]") {
  std::mt19937 random(71);
  std::size_t pairs = 0, pairs_of_default = 0;
  for (int round = 0; round < 60; ++round) {
    const TopologyGraph<> candidate = noisy_graph(random, 8, 3);
    const TopologyGraph<> query = jittered(random, candidate, 1.0);
    for (const RelativePose& pose : match_graphs(candidate, query).poses) {
      pairs_of_default += pose.inliers.size();
    }
    MatchOptions options;
    options.max_residual = 0.05;
    options.inlier_deviations = 2.0;
    for (const RelativePose& pose : match_graphs(candidate, query, options).poses) {
      CHECK(pose.rms <= options.max_residual);
      for (const Correspondence& pair : pose.inliers) {
        const PointPair points = point_pair(candidate.node(pair.candidate), query.node(pair.query));
        CHECK(points.squared_deviation(pose.T_candidate_query) < 9.0);  // it settles on from 2 σ
        ++pairs;
      }
    }
  }
  CHECK(pairs > 0);
  CHECK(pairs < pairs_of_default);
}

TEST_CASE("the poses of a match differ by what the options call distinct", "[matching]") {
  // A grid fits itself when it is turned; of poses that have to lie further apart there are fewer.
  std::size_t last = 100;
  const TopologyGraph<> grid = grid_graph(12, 4, 0.4);
  for (const double least : {0.5, 4.0}) {
    MatchOptions options;
    options.distinct_translation = options.distinct_rotation = least;
    const GraphMatch match = match_graphs(grid, grid, options);
    CHECK(match.poses.size() >= 1);
    CHECK(match.poses.size() < last);
    last = match.poses.size();
    for (std::size_t i = 0; i < match.poses.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        const Eigen::Isometry3d between =
            match.poses[i].T_candidate_query.inverse() * match.poses[j].T_candidate_query;
        CHECK((between.translation().norm() > least ||
               Eigen::AngleAxisd(between.linear()).angle() > least));
      }
    }
  }
}

TEST_CASE("a pose is degenerate below the spread, or above the deviation, of the options",
          "[matching]") {
  std::mt19937 random(72);
  for (int round = 0; round < 30; ++round) {
    const TopologyGraph<> graph = noisy_graph(random, 6, 6);
    const GraphMatch match = match_graphs(graph, graph);
    REQUIRE_FALSE(match.poses.empty());
    const double spread = match.poses.front().spread;
    const double deviation = match.poses.front().rotation_deviation();
    MatchOptions wide, sure;
    wide.min_spread = 1.01 * spread;
    CHECK(match_graphs(graph, graph, wide).poses.front().degenerate);
    wide.min_spread = 0.0;
    wide.max_rotation_deviation = 1.01 * deviation;
    CHECK_FALSE(match_graphs(graph, graph, wide).poses.front().degenerate);
    sure.max_rotation_deviation = 0.99 * deviation;
    CHECK(match_graphs(graph, graph, sure).poses.front().degenerate);
  }
}

TEST_CASE("as many poses are worked out as the options say, at most", "[matching]") {
  const TopologyGraph<> grid = grid_graph(12, 4, 0.4);
  for (const std::size_t most : {1U, 3U, 64U}) {
    MatchOptions options;
    options.max_hypotheses = most;
    CHECK(match_graphs(grid, grid, options).poses.size() <= most);
  }
}

TEST_CASE("what chance explains much better is not worked out, but for the best", "[matching]") {
  MatchOptions every_pose;
  every_pose.min_promise = std::numeric_limits<double>::lowest();
  std::mt19937 random(73);
  std::size_t poses = 0, of_all = 0, followed = 0;
  for (int round = 0; round < 200; ++round) {
    // Every other query shows what the candidate shows.
    const TopologyGraph<> candidate = noisy_graph(random, 8, 2);
    const TopologyGraph<> query =
        round % 2 == 0 ? noisy_graph(random, 8, 2) : jittered(random, candidate, 1.0);
    const GraphMatch match = match_graphs(candidate, query);
    const GraphMatch all = match_graphs(candidate, query, every_pose);
    CHECK(match.complete == all.complete);
    CHECK(match.poses.empty() == all.poses.empty());
    poses += match.poses.size();
    of_all += all.poses.size();
    if (match.poses.empty()) continue;
    if (all.poses.front().score() > 1.0) {
      CHECK(match.poses.front().inliers == all.poses.front().inliers);
      ++followed;
    }
  }
  CHECK(followed >= 80);
  CHECK(poses < of_all);
}
