// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstddef>
#include <random>
#include <set>
#include <vector>

#include <Eigen/Geometry>

#include <topobag/matching/match_graphs.hpp>

#include "catch.hpp"
#include "matching/layouts.hpp"

using namespace topobag;

TEST_CASE("a pair supports a pose within its noise alone", "[matching]") {
  std::mt19937 random(94);
  const TopologyGraph<> place = noisy_graph(random, 6, 6, 0.01);
  for (const double deviations : {2.5, 3.5}) {
    auto nodes = place.nodes();
    nodes.push_back(object_at(9, {0.3, 0.2, 3.0}, 0.04));
    const TopologyGraph<> candidate(nodes);
    // Along the viewing ray: nearly all of it is the noise of the two positions.
    nodes.back().position->z() += deviations * std::sqrt(2.0) * 0.04;
    const GraphMatch match = match_graphs(candidate, TopologyGraph<>(nodes));
    REQUIRE_FALSE(match.poses.empty());
    CHECK(match.poses.front().inliers.size() == (deviations < 3.0 ? 7 : 6));
  }
}

TEST_CASE("no object supports a pose twice", "[matching]") {
  std::mt19937 random(93);
  for (int round = 0; round < 50; ++round) {
    std::vector<SemanticNode<>> nodes = noisy_graph(random, 6, 1).nodes();
    for (std::size_t i = 0; i < 3; ++i) {  // a second one beside it
      nodes.push_back(nodes[i]);
      *nodes.back().position += Eigen::Vector3d::Constant(0.02);
    }
    const TopologyGraph<> crowded(nodes);
    for (const RelativePose& pose : match_graphs(crowded, jittered(random, crowded, 1.0)).poses) {
      std::set<NodeIndex> candidates, queries;
      for (const Correspondence& pair : pose.inliers) {
        CHECK(candidates.insert(pair.candidate).second);
        CHECK(queries.insert(pair.query).second);
      }
    }
  }
}

TEST_CASE("an object missing from a view lowers the score by its cost", "[matching]") {
  std::mt19937 random(100);
  View<> view;
  view.camera = {300.0, 300.0, 319.5, 239.5, 640, 480};
  std::vector<SemanticNode<>> nodes{object_at(1, {0.8, 0.3, 3}), object_at(2, {-0.9, 0.2, 3.5}),
                                    object_at(3, {0.1, -0.8, 2.5}), object_at(4, {0, 0.9, 4})};
  const TopologyGraph<> query(nodes, {}, {view});
  nodes.push_back(object_at(5, {-0.5, -0.5, 3}));
  const GraphMatch match = match_graphs(TopologyGraph<>(nodes), query);
  REQUIRE_FALSE(match.poses.empty());
  const RelativePose& pose = match.poses.front();
  REQUIRE(pose.missing.size() == 1);
  CHECK(pose.missing[0].node == node_index(4));
  CHECK(pose.missing_cost == pose.missing[0].cost);
  CHECK(pose.missing_cost > 0.0);
  CHECK(pose.support() == pose.significance - pose.missing_cost);
  CHECK(pose.score() == pose.support() + pose.viewpoint_odds);
  CHECK(pose.viewpoint_odds == Approx(ViewpointPrior{}.log10_odds(Eigen::Matrix3d::Identity())));
}

TEST_CASE("a pose's covariance is that of the pairs it comes with", "[matching][regression]") {
  std::mt19937 random(96);
  for (int round = 0; round < 300; ++round) {
    const TopologyGraph<> candidate = noisy_graph(random, 12, 2, 0.15);
    const TopologyGraph<> query = jittered(random, candidate, 1.5);
    for (const RelativePose& pose : match_graphs(candidate, query).poses) {
      std::vector<PointPair> points;
      for (const Correspondence& pair : pose.inliers) {
        points.push_back(point_pair(candidate.node(pair.candidate), query.node(pair.query)));
      }
      CAPTURE(round);
      CHECK(pose.covariance.isApprox(pose_covariance(pose.T_candidate_query, points)));
    }
  }
}
