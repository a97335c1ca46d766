// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include <topobag/matching/match_graphs.hpp>
#include <topobag/recognition/relocalizer.hpp>

#include "catch.hpp"
#include "matching/layouts.hpp"

using namespace topobag;

namespace {

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

TEST_CASE("objects off the axis of symmetry settle the pose; one of them is not believed",
          "[matching]") {
  std::mt19937 random(95);
  const TopologyGraph<> one_off = table_group(0.5);
  auto nodes = one_off.nodes();
  for (int i = 0; i < 3; ++i) nodes.push_back(object_at(3 + i, {0.4 - 0.5 * i, -0.1, 3.4}, 0.01));
  const TopologyGraph<> four_off(std::move(nodes));
  for (const auto* candidate : {&one_off, &four_off}) {
    const Eigen::Isometry3d T = random_motion(random, 1.0);
    const TopologyGraph<> query = moved(*candidate, T.inverse());
    const GraphMatch match = match_graphs(*candidate, query);
    REQUIRE(best_of(match).size() == 1);
    CHECK(match.poses.front().T_candidate_query.isApprox(T, 1e-6));
    const Recognition recognition = recognized(*candidate, query);
    REQUIRE(recognition.candidates.size() == 1);
    CHECK(recognition.candidates[0].verdict ==
          (candidate == &one_off ? Verdict::ambiguous : Verdict::accepted));
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

TEST_CASE("a search that leaves poses out says so", "[matching][regression]") {
  MatchOptions options;
  CHECK(match_graphs(table_group(), table_group(), options).complete);
  options.max_hypotheses = 2;  // of the four turns
  CHECK_FALSE(match_graphs(table_group(), table_group(), options).complete);
}

TEST_CASE("a degenerate pose hides no determined one", "[matching][regression]") {
  std::mt19937 random(95);
  MatchOptions options;
  options.min_promise = std::numeric_limits<double>::lowest();
  MatchOptions all_options = options;  // no two poses are the same
  all_options.distinct_translation = all_options.distinct_rotation = -1.0;
  std::size_t beside_a_degenerate_one = 0;
  for (int round = 0; round < 600; ++round) {
    const TopologyGraph<> candidate = noisy_graph(random, 8, 2, 0.25);
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
