// SPDX-License-Identifier: MIT
#include <cstdlib>
#include <fstream>
#include <iostream>

#include <nlohmann/json.hpp>

#include <topobag/evaluation/lifelong_score.hpp>
#include <topobag/evaluation/openloris_trajectory.hpp>

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

std::optional<double> rmse(const std::optional<ErrorStatistics>& statistics) {
  return statistics ? std::optional<double>(statistics->rmse) : std::nullopt;
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

TEST_CASE("the OpenLORIS-Scene benchmark's own numbers", "[evaluation][paper]") {
  const char* data = std::getenv("TOPOBAG_DATA");
  if (data == nullptr) {
    std::cout << "Skips the OpenLORIS-Scene oracle: TOPOBAG_DATA is not set.\n";
    return;
  }
  const std::string folder = std::string(data) + "/openloris/";
  std::ifstream stream(folder + "expected.json");
  const nlohmann::json expected = nlohmann::json::parse(stream).at("results");
  const struct {
    const char* system;
    const char* scene;
    const char* file;
  } cases[] = {{"ds-slam", "cafe", "cafe-1.txt"},
               {"ds-slam", "home", "home-1-1.txt"},
               {"maslam", "cafe", "cafe.txt"},
               {"maslam", "home", "home.txt"},
               {"orbslam2_t265", "cafe", "cafe_1_orbslam2-original.txt"},
               {"orbslam2_t265", "home", "home_1_orbslam2-original.txt"},
               {"vins_mono_color_imu_with_loop", "cafe", "cafe-1.txt"},
               {"vins_mono_color_imu_with_loop", "home", "home-1.txt"}};
  LifelongRules rules;
  rules.ate_threshold_m = 3.0;
  rules.aoe_threshold_deg = 30.0;
  std::size_t sequences = 0;
  for (const auto& [system, scene, file] : cases) {
    const auto estimate = read_openloris(folder + "lifelong/" + system + "/" + file);
    auto truth = read_openloris(folder + "groundtruth/" + scene + ".txt");
    for (auto& [number, trajectory] : truth.sequences) {
      trajectory = in_frame(trajectory, openloris_T_base_frame(estimate.frame).value());
    }
    for (const auto& [number, score] : score_lifelong(truth.sequences, estimate.sequences, rules)) {
      const std::string key = std::string(system) + "/" + scene + "/" + std::to_string(number);
      CAPTURE(key);
      const nlohmann::json& row = expected.at(key);
      const auto check = [&](const char* name, std::optional<double> value) {
        CAPTURE(name);
        REQUIRE(value.has_value() == !row.at(name).is_null());
        if (value) CHECK(*value == Approx(row.at(name).get<double>()).epsilon(0).margin(1e-6));
      };
      ++sequences;
      check("cr", score.cr);
      check("track_cr", score.tracking_cr);
      check("reloc_score", score.cs_r);
      check("reloc_time", score.relocalization_time_s);
      check("aoe_rmse", rmse(score.aoe_deg));
      check("c_ate_rmse", rmse(score.correct_ate_m));
      check("c_ate_num", score.correct_ate_m ? double(score.correct_ate_m->count) : 0.0);
      if (score.errors.empty()) continue;  // there the benchmark's ATE is that of no pose: 0 of 1
      check("ate_rmse", rmse(score.ate_m));
      check("ate_num", double(score.errors.size()));
    }
  }
  CHECK(sequences == expected.size());
}
