// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include <topobag/matching/match_graphs.hpp>
#include <topobag/recognition/relocalizer.hpp>

#include "catch.hpp"
#include "matching/layouts.hpp"

using namespace topobag;

namespace {

double angle_between(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b) {
  return Eigen::AngleAxisd(a.linear().transpose() * b.linear()).angle();
}

/// Four chairs on the floor in a square of 1.2 m and a lamp above its middle: the same again at
/// each quarter turn. With the lamp off the middle only the whole turn is left.
TopologyGraph<> table_group(double lamp_offset = 0.0) {
  std::vector<SemanticNode<>> nodes;
  for (const double x : {-0.6, 0.6}) {
    for (const double z : {-0.6, 0.6}) nodes.push_back(object_at(1, {x, 0.5, 3.0 + z}, 0.01));
  }
  nodes.push_back(object_at(2, {lamp_offset, -0.4, 3.0 + 0.3 * lamp_offset}, 0.01));
  return TopologyGraph<>(std::move(nodes));
}

/// The best poses, which the objects support alike.
std::vector<RelativePose> best_of(const GraphMatch& match) {
  std::vector<RelativePose> best;
  for (const RelativePose& pose : match.poses) {
    if (pose.support() > match.poses.front().support() - 1e-6) best.push_back(pose);
  }
  return best;
}

Recognition recognized(const TopologyGraph<>& candidate, const TopologyGraph<>& query) {
  Relocalizer<> relocalizer;
  relocalizer.map().add(KeyframeId{1}, candidate);
  return relocalizer.localize(query);
}

}  // namespace

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
  for (int round = 0; round < 50; ++round) {
    const TopologyGraph<> candidate = noisy_graph(random, 9, 3, 0.03);
    const TopologyGraph<> query = jittered(random, candidate, 1.0);
    const Eigen::Isometry3d T = random_motion(random, 1.0);
    const RelativePose still = match_graphs(candidate, query).poses.at(0);
    bool found = false;
    for (const RelativePose& pose : match_graphs(candidate, moved(query, T)).poses) {
      found |= (pose.T_candidate_query * T).isApprox(still.T_candidate_query, 1e-6) &&
               std::abs(pose.support() - still.support()) < 1e-6;
    }
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

TEST_CASE("a layout that is itself when turned gives every pose, and none is accepted",
          "[matching]") {
  std::mt19937 random(94);
  const TopologyGraph<> candidate = table_group();
  const Eigen::Isometry3d T = random_motion(random, 1.0);
  const TopologyGraph<> query = moved(table_group(), T.inverse());
  const std::vector<RelativePose> best = best_of(match_graphs(candidate, query));
  REQUIRE(best.size() == 4);
  for (const RelativePose& pose : best) {
    CHECK(pose.inliers.size() == 5);
    CHECK(pose.rms < 1e-6);
    // A multiple of a quarter turn away from the true pose.
    const double quarters = angle_between(pose.T_candidate_query, T) / std::acos(0.0);
    CHECK(quarters == Approx(std::round(quarters)).margin(1e-6));
  }
  const Recognition recognition = recognized(candidate, query);
  CHECK_FALSE(recognition);
  REQUIRE(recognition.candidates.size() == 1);
  CHECK(recognition.candidates[0].verdict == Verdict::ambiguous);
}

TEST_CASE("one object off the axis of symmetry settles the pose", "[matching]") {
  std::mt19937 random(95);
  const TopologyGraph<> candidate = table_group(0.5);
  const Eigen::Isometry3d T = random_motion(random, 1.0);
  const TopologyGraph<> query = moved(candidate, T.inverse());
  const GraphMatch match = match_graphs(candidate, query);
  REQUIRE(best_of(match).size() == 1);
  CHECK(match.poses.front().T_candidate_query.isApprox(T, 1e-6));
  const Recognition recognition = recognized(candidate, query);
  REQUIRE(recognition.candidates.size() == 1);
  CHECK(recognition.candidates[0].verdict == Verdict::accepted);
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

TEST_CASE("objects on a line leave the pose open", "[matching]") {
  std::vector<SemanticNode<>> nodes;
  for (int i = 0; i < 5; ++i) nodes.push_back(object_at(i, {0.4 * i * i - 3.0, 0.0, 4.0}));
  const TopologyGraph<> line(nodes);
  const GraphMatch match = match_graphs(line, line);
  REQUIRE_FALSE(match.poses.empty());
  for (const RelativePose& pose : match.poses) {
    CHECK(pose.degenerate);
    CHECK(pose.spread < 0.01);
  }
  const Recognition recognition = recognized(line, line);
  CHECK_FALSE(recognition);
  CHECK(recognition.candidates.at(0).verdict == Verdict::degenerate);
}

TEST_CASE("objects near a line leave the pose open, however well they are known", "[matching]") {
  const auto near_a_line = [](double off) {
    std::vector<SemanticNode<>> nodes;
    for (int i = 0; i < 5; ++i) {
      nodes.push_back(object_at(i, {0.4 * i * i - 3.0, i % 2 == 0 ? off : -off, 4.0}, 1e-3));
    }
    const TopologyGraph<> graph(nodes);
    return match_graphs(graph, graph).poses.at(0);
  };
  CHECK(near_a_line(0.04).degenerate);
  CHECK(near_a_line(0.04).rotation_deviation() < 0.1);
  CHECK_FALSE(near_a_line(0.08).degenerate);
}

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

TEST_CASE("a search that leaves poses out says so", "[matching][regression]") {
  MatchOptions options;
  CHECK(match_graphs(table_group(), table_group(), options).complete);
  options.max_hypotheses = 2;  // of the four turns
  CHECK_FALSE(match_graphs(table_group(), table_group(), options).complete);
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

TEST_CASE("a degenerate pose hides no determined one", "[matching][regression]") {
  std::mt19937 random(95);
  const MatchOptions options;
  MatchOptions all_options;  // no two poses are the same
  all_options.distinct_translation = all_options.distinct_rotation = -1.0;
  std::size_t beside_a_degenerate_one = 0;
  for (int round = 0; round < 300; ++round) {
    const TopologyGraph<> candidate = noisy_graph(random, 8, 2, 0.15);
    const TopologyGraph<> query = jittered(random, candidate, 1.5);
    const GraphMatch match = match_graphs(candidate, query, options);
    const auto near = [&](const RelativePose& a, const RelativePose& b) {
      const Eigen::Isometry3d between = a.T_candidate_query.inverse() * b.T_candidate_query;
      return between.translation().norm() <= options.distinct_translation &&
             Eigen::AngleAxisd(between.linear()).angle() <= options.distinct_rotation;
    };
    for (const RelativePose& pose : match_graphs(candidate, query, all_options).poses) {
      if (pose.degenerate) continue;
      bool told = false;
      for (const RelativePose& other : match.poses) {
        if (!near(other, pose) || other.score() < pose.score()) continue;
        told = told || !other.degenerate;
        beside_a_degenerate_one += other.degenerate ? 1 : 0;
      }
      CAPTURE(round);
      CHECK(told);
    }
  }
  CHECK(beside_a_degenerate_one > 0);
}
