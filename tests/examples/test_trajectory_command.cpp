// SPDX-License-Identifier: MIT
#include <cmath>

#include <nlohmann/json.hpp>

#include "catch.hpp"
#include "run_program.hpp"

using nlohmann::json;

namespace {

std::string trajectory(const std::string& arguments) {
  const ProgramRun run = run_program("trajectory " + arguments);
  INFO(run.err);
  REQUIRE(run.exit_code == 0);
  return run.out;
}

/// Five poses 1 s and 1 m apart along x.
std::string drive(const std::string& header, double scale) {
  std::string text = header;
  for (int i = 0; i < 5; ++i) {
    text += std::to_string(i) + ' ' + std::to_string(scale * i) + " 0 0 0 0 0 1\n";
  }
  return text;
}

}  // namespace

TEST_CASE("topobag trajectory: an estimate that is half as long", "[program][evaluation]") {
  const ScratchFolder folder;
  const std::string files = "--groundtruth " + folder.write("truth.txt", drive("", 1.0)) +
                            " --estimate " + folder.write("half.txt", drive("", 0.5)) + " --json";
  const json aligned = json::parse(trajectory(files)).at("sequences").at("1");
  CHECK(aligned.at("ate_rmse") == Approx(std::sqrt((1.0 + 0.25 + 0.25 + 1.0) / 5.0)));
  CHECK(aligned.at("rpe_m").at("rmse") == Approx(0.5));
  const json scaled = json::parse(trajectory(files + " --alignment sim3")).at("sequences").at("1");
  CHECK(scaled.at("ate_rmse") == Approx(0.0).margin(1e-12));
  CHECK(scaled.at("rpe_m").at("rmse") == Approx(0.0).margin(1e-12));
  const json as_is = json::parse(trajectory(files + " --alignment none --ate-threshold 1.1"));
  CHECK(as_is.at("sequences").at("1").at("cr") == 0.75);
  CHECK(as_is.at("rules").at("ate_threshold_m") == 1.1);
  CHECK(as_is.at("rules").at("aoe_threshold_deg").is_null());
  CHECK(trajectory(files + " --rpe-unit metres --rpe-step 2 --rpe-consecutive")
            .find("\"rpe_steps\": 2") != std::string::npos);
}

TEST_CASE("topobag trajectory: OpenLORIS files, the body frame and undefined values",
          "[program][evaluation]") {
  const ScratchFolder folder;
  const std::string truth = folder.write(
      "truth.txt", drive("scene: lab\nframe: base_link\nseq: 1\n", 1.0) + drive("seq: 2\n", 1.0));
  const std::string estimate =
      folder.write("slam.txt", drive("scene: lab\nframe: d400_color\nseq: 1\n", 1.0) + "seq: 2\n");
  const std::string files = "--groundtruth " + truth + " --estimate " + estimate + " --json";
  const json result = json::parse(trajectory(files + " --body-frame auto"));
  CHECK(result.at("rules").at("interpolation") == "openloris");
  CHECK(result.at("sequences").at("1").at("matched") == 5);
  const json& second = result.at("sequences").at("2");
  for (const char* key : {"ate_rmse", "aoe_rmse", "relocalization_time_s", "rpe_m"}) {
    CHECK(second.at(key).is_null());
  }
  CHECK(second.at("cr") == 0.0);

  // The body one metre to the left: the same path, beside it.
  const std::string by_hand = trajectory(files + " --alignment none --errors " +
                                         folder.path("errors.csv") + " --body-frame 0 1 0 0 0 0 1");
  CHECK(json::parse(by_hand).at("sequences").at("1").at("ate_rmse") == 1.0);
  CHECK(program::read_file(folder.path("errors.csv")).substr(0, 45) ==
        "sequence,timestamp,ate_m,aoe_deg\n1,0,1,0\n1,1,");
  CHECK(refusal("trajectory " + files + " --body-frame 0 1 0").find("--body-frame") !=
        std::string::npos);
  CHECK(refusal("trajectory " + files + " --body-frame 0 1 0 0 0 0 2").find("--body-frame") !=
        std::string::npos);
  CHECK(refusal("trajectory " + files + " --times x").find("KITTI") != std::string::npos);
  CHECK(refusal("trajectory --groundtruth " + truth + " --estimate " + folder.path("none.txt"))
            .find("none.txt") != std::string::npos);
}

TEST_CASE("topobag trajectory: KITTI poses with their times, frames of a node table",
          "[program][evaluation]") {
  const ScratchFolder folder;
  const std::string kitti = folder.write(
      "00.txt", "1 0 0 0 0 1 0 0 0 0 1 0\n1 0 0 1 0 1 0 0 0 0 1 0\n1 0 0 2 0 1 0 0 0 0 1 0\n");
  const std::string times = folder.write("times.txt", "10\n10.1\n10.2\n");
  const std::string frames =
      folder.write("set.frames.csv",
                   "idx,frame,timestamp,tx,ty,tz,qx,qy,qz,qw\n0,a,10.05,0.5,0,0,0,0,0,1\n"
                   "1,b,10.2,2,0,0,0,0,0,1\n");
  const json result = json::parse(trajectory("--groundtruth " + kitti + " --times " + times +
                                             " --estimate " + frames + " --alignment none --json"));
  CHECK(result.at("sequences").at("1").at("matched") == 2);
  CHECK(result.at("sequences").at("1").at("ate_rmse") == Approx(0.0).margin(1e-9));
  CHECK(result.at("sequences").at("1").at("relocalization_time_s") == Approx(0.05));
}

TEST_CASE("topobag trajectory: rules are finite and above 0", "[program][evaluation]") {
  for (const std::string rule : {"--ate-threshold", "--aoe-threshold", "--tau",
                                 "--max-pose-interval", "--max-gap", "--rpe-step"}) {
    for (const std::string value : {"nan", "0", "-1"}) {
      CHECK(refusal("trajectory --groundtruth a --estimate b " + rule + ' ' + value)
                .find("'" + value + "' is not a number in (0, inf)") != std::string::npos);
    }
  }
}
