// SPDX-License-Identifier: MIT
#include <cstdlib>
#include <fstream>
#include <iostream>

#include <nlohmann/json.hpp>

#include <topobag/evaluation/lifelong_score.hpp>
#include <topobag/evaluation/openloris_trajectory.hpp>

#include "catch.hpp"

using namespace topobag;

namespace {

std::optional<double> rmse(const std::optional<ErrorStatistics>& statistics) {
  return statistics ? std::optional<double>(statistics->rmse) : std::nullopt;
}

}  // namespace

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
