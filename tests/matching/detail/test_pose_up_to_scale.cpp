// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

#include <Eigen/Geometry>

#include <topobag/graph/scaled_graph.hpp>
#include <topobag/matching/judge_pose.hpp>
#include <topobag/matching/match_graphs.hpp>

#include "catch.hpp"
#include "matching/layouts.hpp"

using namespace topobag;

namespace {

MatchOptions of_unknown_scale() {
  MatchOptions options;
  options.scale = ScaleRange{};
  return options;
}

/// A place seen twice with noise, the second time from elsewhere and in another unit.
struct TwoUnits {
  TwoUnits(std::mt19937& random, std::size_t objects, int classes, double motion = 1.0) {
    std::uniform_real_distribution<double> log_scale(std::log(0.4), std::log(2.5));
    scale = std::exp(log_scale(random));
    T_candidate_query = random_motion(random, motion);
    const TopologyGraph<> place = noisy_graph(random, objects, classes, 0.02);
    candidate = jittered(random, place, 1.0);
    in_metres = moved(jittered(random, place, 1.0), T_candidate_query.inverse());
    query = scaled(in_metres, 1.0 / scale);
  }

  bool fits(const RelativePose& pose) const {
    return (pose.T_candidate_query.inverse() * T_candidate_query).translation().norm() < 0.3 &&
           angle_between(pose.T_candidate_query, T_candidate_query) < 0.1;
  }

  double scale = 1.0;  ///< candidate's metres in a unit of the query
  Eigen::Isometry3d T_candidate_query;
  TopologyGraph<> candidate, query;
  TopologyGraph<> in_metres;  ///< the query, had it known its unit
};

}  // namespace

TEST_CASE("a graph in another unit is matched with its pose and its scale", "[matching]") {
  std::mt19937 random(2201);
  const MatchOptions options = of_unknown_scale();
  const int rounds = 100;
  int found = 0;
  double chi2 = 0.0;
  for (int round = 0; round < rounds; ++round) {
    const TwoUnits views(random, 8, 4);
    const GraphMatch match = match_graphs(views.candidate, views.query, options);
    CAPTURE(round, views.scale);
    REQUIRE_FALSE(match.poses.empty());
    const RelativePose& best = match.poses.front();
    CHECK(views.fits(best));
    CHECK_FALSE(best.degenerate);
    const double off = (best.scale - views.scale) / best.scale_deviation;
    CHECK(std::abs(off) < 4.0);
    chi2 += off * off / rounds;
    found += best.inliers.size() >= 7 ? 1 : 0;
    for (const Correspondence& pair : best.inliers) {
      const Eigen::Vector3d there = *views.candidate.node(pair.candidate).position;
      CHECK((best.in_candidate(*views.query.node(pair.query).position) - there).norm() < 0.3);
    }
  }
  CHECK(found > 90);
  CHECK(chi2 > 0.3);
  CHECK(chi2 < 1.5);
}

TEST_CASE("pose and scale err together as they say", "[matching]") {
  std::mt19937 random(2215);
  const MatchOptions options = of_unknown_scale();
  const int rounds = 100;
  double chi2 = 0.0, opposite = 0.0;
  for (int round = 0; round < rounds; ++round) {
    const TwoUnits views(random, 8, 4);
    const GraphMatch match = match_graphs(views.candidate, views.query, options);
    REQUIRE_FALSE(match.poses.empty());
    const RelativePose& pose = match.poses.front();
    const double deviation = pose.scale_deviation / pose.scale;
    Eigen::Matrix<double, 7, 7> covariance;
    covariance << pose.covariance, pose.scale_covariance, pose.scale_covariance.transpose(),
        deviation * deviation;
    const Eigen::Isometry3d error = views.T_candidate_query * pose.T_candidate_query.inverse();
    const Eigen::AngleAxisd turn(error.linear());
    Eigen::Matrix<double, 7, 1> off;
    off << error.translation(), turn.angle() * turn.axis(), std::log(views.scale / pose.scale);
    chi2 += off.dot(covariance.llt().solve(off)) / rounds;
    // With the sign of how they go together wrong it is far more.
    covariance.topRightCorner<6, 1>() *= -1.0;
    covariance.bottomLeftCorner<1, 6>() *= -1.0;
    opposite += off.dot(covariance.llt().solve(off)) / rounds;
  }
  CHECK(chi2 > 2.5);  // a pose's covariance is on the careful side
  CHECK(chi2 < 9.0);
  CHECK(opposite > 2.0 * chi2);
}

TEST_CASE("an unknown scale costs what the model says and not much more", "[matching]") {
  std::mt19937 random(2209);
  const MatchOptions options = of_unknown_scale();
  double lost = 0.0, said = 0.0;
  const int rounds = 60;
  for (int round = 0; round < rounds; ++round) {
    const TwoUnits views(random, 9, 4);
    const GraphMatch known = match_graphs(views.candidate, views.in_metres);
    const GraphMatch unknown = match_graphs(views.candidate, views.query, options);
    REQUIRE_FALSE(known.poses.empty());
    REQUIRE_FALSE(unknown.poses.empty());
    const RelativePose& pose = unknown.poses.front();
    lost += known.poses.front().significance - pose.significance;
    said += ChanceModel::log10_scale_cost(*options.scale, pose.scale_deviation / pose.scale);
  }
  CHECK(lost / rounds > 0.5 * said / rounds);
  CHECK(lost / rounds < said / rounds + 1.5);
}

TEST_CASE("graphs exchanged exchange the scale", "[matching]") {
  std::mt19937 random(2210);
  const MatchOptions options = of_unknown_scale();
  for (int round = 0; round < 50; ++round) {
    const TwoUnits views(random, 9, 4);
    const GraphMatch forth = match_graphs(views.candidate, views.query, options);
    const GraphMatch back = match_graphs(views.query, views.candidate, options);
    CAPTURE(round, views.scale);
    REQUIRE_FALSE(forth.poses.empty());
    REQUIRE_FALSE(back.poses.empty());
    const RelativePose &a = forth.poses.front(), &b = back.poses.front();
    CHECK(a.scale * b.scale ==
          Approx(1.0).margin(4.0 * std::max(a.scale_deviation / a.scale, 0.01)));
    // x = T (s · y), so y = T⁻¹ moved to the other unit: its rotation is the inverse.
    CHECK(angle_between(a.T_candidate_query, b.T_candidate_query.inverse()) < 0.1);
    const Eigen::Vector3d camera = b.in_candidate(a.T_candidate_query.translation());
    CHECK(camera.norm() < 0.3 / views.scale);
  }
}

TEST_CASE("the unit in which a query is given does not matter to its score", "[matching]") {
  std::mt19937 random(2211);
  MatchOptions options = of_unknown_scale();
  options.scale = ScaleRange{0.05, 20.0};
  int same = 0;
  for (int round = 0; round < 50; ++round) {
    const TwoUnits views(random, 9, 4);
    const GraphMatch one = match_graphs(views.candidate, views.query, options);
    const GraphMatch other = match_graphs(views.candidate, scaled(views.query, 1.7), options);
    REQUIRE_FALSE(one.poses.empty());
    REQUIRE_FALSE(other.poses.empty());
    const RelativePose &a = one.poses.front(), &b = other.poses.front();
    same +=
        std::abs(a.support() - b.support()) < 0.1 && std::abs(a.scale / b.scale / 1.7 - 1.0) < 1e-2;
  }
  CHECK(same >= 47);  // votes fall into bins, and a start near the edge may end elsewhere
}

TEST_CASE("too few objects say nothing of scale and pose", "[matching]") {
  std::mt19937 random(2212);
  const MatchOptions options = of_unknown_scale();
  int known = 0;
  for (int round = 0; round < 30; ++round) {
    const TwoUnits views(random, 3, 3);
    CHECK(match_graphs(views.candidate, views.query, options).poses.empty());
    CHECK_FALSE(
        judge_pose(views.candidate, views.query, views.T_candidate_query, options, views.scale));
    known += judge_pose(views.candidate, views.in_metres, views.T_candidate_query) ? 1 : 0;
  }
  CHECK(known > 20);
  // One fewer where the vertical is known.
  TwoUnits views(random, 3, 3, 0.0);
  const auto with_gravity = [](const TopologyGraph<>& graph, const Eigen::Vector3d& down) {
    return TopologyGraph<>(graph.nodes(), {}, {}, Gravity<>{down, 0.01});
  };
  const Eigen::Vector3d down = Eigen::Vector3d::UnitY();
  views.candidate = with_gravity(views.candidate, down);
  views.query = with_gravity(views.query, views.T_candidate_query.linear().transpose() * down);
  const auto pose =
      judge_pose(views.candidate, views.query, views.T_candidate_query, options, views.scale);
  REQUIRE(pose);
  CHECK(pose->inliers.size() == 3);
  CHECK(pose->scale == Approx(views.scale).epsilon(0.1));
}

TEST_CASE("a pose that is about known is judged with its scale", "[matching]") {
  std::mt19937 random(2213);
  const MatchOptions options = of_unknown_scale();
  std::uniform_real_distribution<double> off(0.97, 1.03);
  int found = 0;
  for (int round = 0; round < 50; ++round) {
    const TwoUnits views(random, 8, 4);
    const auto pose = judge_pose(views.candidate, views.query, views.T_candidate_query, options,
                                 off(random) * views.scale);
    if (!pose) continue;
    ++found;
    CHECK(std::abs(pose->scale - views.scale) < 4.0 * pose->scale_deviation);
    CHECK(views.fits(*pose));
  }
  CHECK(found >= 40);
}

TEST_CASE("a known scale is one", "[matching]") {
  std::mt19937 random(2214);
  const TopologyGraph<> place = noisy_graph(random, 8, 4, 0.02);
  const GraphMatch match = match_graphs(place, jittered(random, place, 1.0));
  REQUIRE_FALSE(match.poses.empty());
  CHECK(match.poses.front().scale == 1.0);
  CHECK(match.poses.front().scale_deviation == 0.0);
}
