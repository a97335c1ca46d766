// SPDX-License-Identifier: MIT
#include <algorithm>
#include <random>
#include <set>
#include <vector>

#include <topobag/matching/coincident_objects.hpp>

#include "catch.hpp"
#include "matching/layouts.hpp"

using namespace topobag;

namespace {

RelativePose pose_at(const Eigen::Isometry3d& T) {
  RelativePose pose;
  pose.T_candidate_query = T;
  return pose;
}

}  // namespace

TEST_CASE("objects at one place are paired whatever their class", "[matching]") {
  const Eigen::Isometry3d T(Eigen::Translation3d(0.5, 0, 1));
  const TopologyGraph<> candidate({object_at(1, {0, 0, 3}), object_at(2, {1, 0, 3})});
  const TopologyGraph<> query =
      moved(TopologyGraph<>({object_at(7, {1.02, 0, 3}), object_at(1, {2, 0, 3})}), T.inverse());
  const auto pairs = coincident_objects(candidate, query, pose_at(T));
  REQUIRE(pairs.size() == 1);
  CHECK(pairs[0] == Correspondence{node_index(1), node_index(0)});
}

TEST_CASE("an inlier stays, however close another object is", "[matching]") {
  const TopologyGraph<> candidate({object_at(1, {0, 0, 3})});
  const TopologyGraph<> query({object_at(1, {0.05, 0, 3}), object_at(1, {0, 0, 3})});
  RelativePose pose;
  CHECK(coincident_objects(candidate, query, pose)[0].query == node_index(1));
  pose.inliers = {{node_index(0), node_index(0)}};
  CHECK(coincident_objects(candidate, query, pose) == pose.inliers);
}

TEST_CASE("both the deviations and the distance are bounded", "[matching]") {
  const TopologyGraph<> sharp({object_at(1, {0, 0, 3}, 0.02)});
  const TopologyGraph<> vague({object_at(1, {0, 0, 3}, 1.0)});
  const auto count = [](const TopologyGraph<>& graph, double apart) {
    const TopologyGraph<> other =
        moved(graph, Eigen::Isometry3d(Eigen::Translation3d(apart, 0, 0)));
    return coincident_objects(graph, other, RelativePose{}).size();
  };
  CHECK(count(sharp, 0.08) == 1);  // 2.8 deviations of two objects' noise
  CHECK(count(sharp, 0.09) == 0);
  CHECK(count(vague, 0.39) == 1);
  CHECK(count(vague, 0.41) == 0);
}

TEST_CASE("pairs are one-to-one and the closest first, against brute force", "[matching]") {
  std::mt19937 random(71);
  for (int round = 0; round < 50; ++round) {
    const TopologyGraph<> candidate = noisy_graph(random, 12, 3, 0.3);
    const TopologyGraph<> query = jittered(random, candidate, 1.0);
    const auto pairs = coincident_objects(candidate, query, RelativePose{}, {3.0, 1.0});
    CHECK(std::is_sorted(pairs.begin(), pairs.end()));
    std::set<NodeIndex> candidates, queries;
    for (const Correspondence& pair : pairs) {
      candidates.insert(pair.candidate);
      queries.insert(pair.query);
    }
    CHECK(candidates.size() == pairs.size());
    CHECK(queries.size() == pairs.size());
    // No two left-over objects would still fit.
    for (std::size_t p = 0; p < candidate.size(); ++p) {
      for (std::size_t q = 0; q < query.size(); ++q) {
        if (candidates.count(node_index(p)) != 0 || queries.count(node_index(q)) != 0) continue;
        const auto &there = candidate.nodes()[p], &here = query.nodes()[q];
        const PointPair points{*there.position, *here.position, there.covariance, here.covariance};
        const Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
        CHECK((points.residual(T).norm() > 1.0 || points.squared_deviation(T) > 9.0));
      }
    }
  }
}

TEST_CASE("an object without a position is at no place", "[matching]") {
  SemanticNode<> unplaced = object_at(1, {0, 0, 3});
  const TopologyGraph<> placed({unplaced});
  unplaced.position.reset();
  CHECK(coincident_objects(placed, TopologyGraph<>({unplaced}), RelativePose{}).empty());
  CHECK(coincident_objects(TopologyGraph<>({unplaced}), placed, RelativePose{}).empty());
}
