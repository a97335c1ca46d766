// SPDX-License-Identifier: MIT
// What `--calibrate` learns of looks, on the sample's, whose colours are given out for a method of
// which nothing is known beforehand.
#include <optional>
#include <string>

#include <nlohmann/json.hpp>

#include <topobag/recognition/calibration_text.hpp>

#include "catch.hpp"
#include "csv_reader.hpp"
#include "node_table.hpp"
#include "run_program.hpp"
#include "sample.hpp"

namespace {

using LooksJson = nlohmann::json;

const topobag::AppearanceKind unknown_kind("layer neck", topobag::ColorDescriptor::kind.length());

/// The sample's table with the looks of a method of that name, or none.
std::string sample_with_looks(const ScratchFolder& folder, const std::string& set,
                              const std::string& name, bool looks = true) {
  program::NodeTable table = program::read_node_table(set);
  table.appearance = looks ? "layer neck" : "";
  for (auto& frame : table.frames) {
    for (auto& detection : frame.detections) {
      if (!detection.appearance.known()) continue;
      detection.appearance = looks ? topobag::Appearance(unknown_kind, detection.appearance.bytes())
                                   : topobag::Appearance();
    }
  }
  program::write_node_table(folder.path(name), table);
  return folder.path(name);
}

LooksJson looks_run(const std::string& arguments) {
  const ProgramRun run = run_program(arguments + sample_options + "--json");
  CAPTURE(arguments, run.err);
  REQUIRE(run.exit_code == 0);
  return LooksJson::parse(run.out);
}

/// Of the first match of an explanation whose candidate was accepted.
std::optional<double> explained_looks(const LooksJson& explanation) {
  for (const LooksJson& candidate : explanation.at("candidates")) {
    if (candidate.at("verdict") != "accepted") continue;
    for (const LooksJson& matched : candidate.at("matched")) {
      if (matched.contains("looks")) return matched.at("looks").get<double>();
    }
  }
  return std::nullopt;
}

}  // namespace

TEST_CASE("calibrating learns what looks say, keeps it, and goes by it again",
          "[examples][appearance]") {
  const ScratchFolder folder;
  const std::string map = sample_with_looks(folder, sample_map, "map");
  const std::string query = sample_with_looks(folder, sample_query, "query");
  const std::string file = folder.path("neck.calibration");
  const std::string tables = " --map " + map + " --query " + query + " --false-accept-rate 0.02";
  const LooksJson learnt =
      looks_run("localize" + tables + " --calibrate --save-calibration " + file);
  CHECK(learnt.at("calibration").at("learnt_looks") == true);
  CHECK(learnt.at("wrong") == 0);
  const topobag::Calibration calibration = topobag::parse_calibration(program::read_file(file));
  REQUIRE(calibration.appearance());
  CHECK(calibration.appearance()->kind == unknown_kind);
  CHECK(calibration.appearance()->log10_odds(0.99) > 0.2);
  CHECK(calibration.appearance()->log10_odds(0.5) < -0.2);

  const LooksJson again = looks_run("localize" + tables + " --calibration " + file);
  CHECK(again.at("calibration") == learnt.at("calibration"));
  CHECK(again.at("matches") == learnt.at("matches"));
  const ProgramRun table =
      run_program("localize" + tables + " --calibration " + file + sample_options);
  CHECK(table.out.find("looks         as learnt before") != std::string::npos);

  const std::string frame =
      " --frame " + std::to_string(learnt.at("matches").at(0).at("query_idx").get<int>());
  CHECK(explained_looks(looks_run("explain" + tables + frame + " --calibration " + file)));
  CHECK_FALSE(explained_looks(looks_run("explain" + tables + frame)));
}

TEST_CASE("a calibration of looks of one kind is none for a map of another",
          "[examples][appearance]") {
  const ScratchFolder folder;
  const std::string map = sample_with_looks(folder, sample_map, "map");
  const std::string file = folder.path("neck.calibration");
  const LooksJson learnt =
      looks_run("loops --min-gap 5 --calibrate --save-calibration " + file + " --nodes " + map);
  REQUIRE(learnt.at("calibration").at("learnt_looks") == true);
  CHECK(refusal("localize --map " + sample_map + " --query " + sample_query + " --calibration " +
                file + sample_options) ==
        "the calibration learnt looks by descriptors of another kind (54 numbers) than the map's "
        "(54 numbers): calibrate this map anew");
}

TEST_CASE("without looks a calibration is what it was", "[examples][appearance]") {
  const ScratchFolder folder;
  const std::string map = sample_with_looks(folder, sample_map, "map", false);
  const std::string file = folder.path("plain.calibration");
  const LooksJson learnt =
      looks_run("loops --min-gap 5 --calibrate --save-calibration " + file + " --nodes " + map);
  CHECK(learnt.at("calibration").at("learnt_looks") == false);
  CHECK(program::read_file(file).find("appearance_") == std::string::npos);
  CHECK_FALSE(topobag::parse_calibration(program::read_file(file)).appearance());
}

TEST_CASE("too few pairs teach nothing of looks, and it is said", "[examples][appearance]") {
  const ScratchFolder folder;
  const std::string map = sample_with_looks(folder, sample_map, "map");
  // Of one visit: no two key frames are 1,000 s apart.
  const ProgramRun run = run_program("localize --keyframe-interval 5 --calibrate --map " + map +
                                     " --query " + map + " --camera 517.3,516.5,318.6,255.3");
  CHECK(run.exit_code == 0);
  CHECK(run.out.find("looks         not learnt of ") != std::string::npos);
  CHECK(run.out.find("; it takes 100 of either\n") != std::string::npos);
}
