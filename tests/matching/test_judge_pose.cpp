// SPDX-License-Identifier: MIT
#include <random>

#include <topobag/matching/judge_pose.hpp>
#include <topobag/matching/match_graphs.hpp>

#include "catch.hpp"
#include "layouts.hpp"

using namespace topobag;

TEST_CASE("a pose that was found is judged as the search judged it", "[matching]") {
  std::mt19937 random(7);
  std::size_t judged_poses = 0;
  for (int round = 0; round < 200; ++round) {
    const TopologyGraph<> candidate = noisy_graph(random, 7, 3);
    const TopologyGraph<> query = jittered(random, candidate, 0.5);
    for (const RelativePose& pose : match_graphs(candidate, query).poses) {
      const auto judged = judge_pose(candidate, query, pose.T_candidate_query);
      if (!judged || judged->inliers != pose.inliers) continue;  // it may settle on others
      ++judged_poses;
      CHECK(judged->significance == Approx(pose.significance).margin(1e-3));
      CHECK(judged->T_candidate_query.isApprox(pose.T_candidate_query, 1e-3));
    }
  }
  CHECK(judged_poses > 150);
}

TEST_CASE("a pose with which too few objects agree is none", "[matching]") {
  const TopologyGraph<> graph = grid_graph(6, 3, 0.5);
  const Eigen::Isometry3d away(Eigen::Translation3d(20.0, 0.0, 0.0));
  CHECK_FALSE(judge_pose(graph, graph, away));
  CHECK_FALSE(judge_pose(graph, TopologyGraph<>{}, Eigen::Isometry3d::Identity()));
}

TEST_CASE("however many pairs are offered, a pose is judged by all of them",
          "[matching][regression]") {
  const TopologyGraph<> crowd = grid_graph(40, 8, 0.6);  // 1,600 pairs of one class
  REQUIRE(MatchOptions{}.consistency.max_pairs < 1600);
  const auto judged = judge_pose(crowd, crowd, Eigen::Isometry3d::Identity());
  REQUIRE(judged);
  CHECK(judged->inliers.size() == 40);
}
