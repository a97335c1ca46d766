// SPDX-License-Identifier: MIT
#include <cmath>

#include <topobag/evaluation/lifelong_score.hpp>

#include "catch.hpp"
#include "evaluation/random_poses.hpp"

using namespace topobag;
using topobag_tests::planar_pose;

namespace {

/// Standing at the origin for 100 s, ten poses a second.
Trajectory standing() {
  Trajectory truth;
  for (int i = 0; i <= 1000; ++i) truth.push_back({0.1 * i, planar_pose(0, 0, 0)});
  return truth;
}

LifelongRules rules_without_alignment() {
  LifelongRules rules;
  rules.ate_threshold_m = 1.0;
  rules.aoe_threshold_deg = 30.0;
  rules.alignment = AlignmentModel::none;
  return rules;
}

}  // namespace

TEST_CASE("CR, tracking CR and CS-R of a hand-made sequence", "[evaluation][paper]") {
  // Re-localized after 30 s; correct for 0.5 s, then wrong by angle, then correct up to a silence,
  // of which 1 s counts, then wrong by distance, and correct once more 0.4 s before the end.
  const Trajectory estimate{{30.0, planar_pose(0.5, 0, 0)}, {30.5, planar_pose(0, 0, 31)},
                            {31.0, planar_pose(0, 0, 29)},  {50.0, planar_pose(1.5, 0, 0)},
                            {99.6, planar_pose(1.0, 0, 0)}, {120.0, planar_pose(0, 0, 0)}};
  const SequenceScore score =
      score_lifelong({{1, standing()}}, {{1, estimate}}, rules_without_alignment()).at(1);
  CHECK(score.poses == 6);
  CHECK(score.errors.size() == 5);
  CHECK(*score.cr == Approx((0.5 + 1.0 + 0.4) / 100.0));
  CHECK(*score.tracking_cr == Approx((0.5 + 1.0 + 0.4) / 70.0));
  CHECK(*score.relocalization_time_s == Approx(30.0));
  CHECK(score.cs_r == Approx(std::exp(-0.5)));
  CHECK(score.correct_ate_m->count == 3);
  CHECK(score.ate_m->rmse == Approx(std::sqrt((0.25 + 2.25 + 1.0) / 5.0)));
  CHECK(score.aoe_deg->max == Approx(31.0));
}

TEST_CASE("CS-R is 0 when the first pose is wrong", "[evaluation][paper]") {
  const Trajectory estimate{{1.0, planar_pose(2, 0, 0)}, {2.0, planar_pose(0, 0, 0)}};
  const SequenceScore score =
      score_lifelong({{1, standing()}}, {{1, estimate}}, rules_without_alignment()).at(1);
  CHECK(score.cs_r == 0.0);
  CHECK(*score.cr == Approx(0.01));
}

TEST_CASE("the first sequence's alignment is everybody's", "[evaluation]") {
  std::mt19937 random(8);
  const Trajectory truth = topobag_tests::random_trajectory(random, 50);
  const Eigen::Isometry3d world = topobag_tests::random_pose(random);
  const auto seen_from = [&](const Eigen::Isometry3d& T) {
    Trajectory moved = truth;
    for (StampedPose& pose : moved) pose.T_world_body = T * pose.T_world_body;
    return moved;
  };
  LifelongRules rules = rules_without_alignment();
  rules.alignment = AlignmentModel::se3;
  const auto scores =
      score_lifelong({{1, truth}, {2, truth}, {3, truth}},
                     {{2, seen_from(world)}, {3, seen_from(world * planar_pose(0, 0, 90))}}, rules);
  REQUIRE(scores.size() == 2);
  CHECK(scores.at(2).ate_m->rmse < 1e-9);
  CHECK(*scores.at(2).cr == Approx(1.0));
  CHECK(scores.at(3).aoe_deg->rmse == Approx(90.0));
  CHECK(*scores.at(3).cr == 0.0);
}

TEST_CASE("sequences without a matched pose, without a duration, without a truth", "[evaluation]") {
  const auto none = score_lifelong({{1, standing()}}, {{1, {}}}).at(1);
  CHECK(*none.cr == 0.0);
  CHECK(*none.tracking_cr == 0.0);
  CHECK(none.cs_r == 0.0);
  CHECK_FALSE(none.ate_m);
  CHECK_FALSE(none.relocalization_time_s);
  const Trajectory moment{{5.0, planar_pose(0, 0, 0)}};
  const auto instant = score_lifelong({{1, moment}}, {{1, moment}}).at(1);
  CHECK_FALSE(instant.cr);
  CHECK_FALSE(instant.tracking_cr);
  CHECK(instant.cs_r == 1.0);
  CHECK_THROWS_AS(score_lifelong({{1, standing()}}, {{2, moment}}), Error);
  CHECK(score_lifelong({{1, standing()}}, {}).empty());
}
