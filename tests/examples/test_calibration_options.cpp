// SPDX-License-Identifier: MIT
#include <string>

#include <nlohmann/json.hpp>

#include <topobag/recognition/calibration_text.hpp>

#include "catch.hpp"
#include "csv_reader.hpp"
#include "desk_twice.hpp"
#include "run_program.hpp"
#include "sample.hpp"

namespace {

using CalibrationJson = nlohmann::json;

const std::string calibrated_tables = "--map " + sample_map + " --query " + sample_query;

CalibrationJson calibrated_run(const std::string& arguments) {
  const ProgramRun run = run_program(arguments + sample_options + " --json");
  CAPTURE(arguments, run.err);
  REQUIRE(run.exit_code == 0);
  return CalibrationJson::parse(run.out);
}

}  // namespace

TEST_CASE("a calibrated decision reports what it rests on", "[examples]") {
  const std::string command = "localize " + calibrated_tables + " --calibrate";
  const CalibrationJson report = calibrated_run(command + " --false-accept-rate 0.02");
  const CalibrationJson& calibration = report.at("calibration");
  CHECK(calibration.at("false_accept_rate") == 0.02);
  CHECK(calibration.at("source") == "null model");
  CHECK(calibration.at("queries") == 400);
  CHECK(calibration.at("extrapolated") == false);
  CHECK(calibration.at("certain_negatives") < 200);  // it is a map of one desk
  CHECK(calibration.at("warning").is_null());
  CHECK(report.at("accepted") > 0);
  for (const CalibrationJson& match : report.at("matches")) {
    CHECK(match.at("score") >= calibration.at("threshold"));
    CHECK(match.at("confidence") > 0.9);
    CHECK(match.at("confidence") <= 401.0 / 402.0 + 1e-12);
    CHECK(match.at("confidence_extrapolated").is_boolean());
  }
  const CalibrationJson strict =
      calibrated_run(command + " --false-accept-rate 1e-5").at("calibration");
  CHECK(strict.at("extrapolated") == true);
  CHECK(strict.at("threshold") > calibration.at("threshold"));
  CHECK(calibrated_run(command).at("calibration").at("false_accept_rate") == 0.001);
  CHECK_FALSE(calibrated_run("localize " + calibrated_tables).contains("calibration"));
}

TEST_CASE("what was learnt is kept and used again", "[examples]") {
  const ScratchFolder folder;
  const std::string file = folder.path("kitchen.calibration");
  const std::string rate = " --false-accept-rate 0.02 ";
  const std::string localize = "localize " + calibrated_tables + rate;
  const CalibrationJson learnt =
      calibrated_run(localize + "--calibrate --save-calibration " + file);
  const CalibrationJson again = calibrated_run(localize + "--calibration " + file);
  CHECK(again.at("calibration") == learnt.at("calibration"));
  CHECK(again.at("matches") == learnt.at("matches"));
  CHECK(topobag::parse_calibration(program::read_file(file)).queries() == 400);

  const std::string frame = std::to_string(learnt.at("matches").at(0).at("query_idx").get<int>());
  const CalibrationJson explained = calibrated_run("explain " + calibrated_tables + rate +
                                                   "--calibration " + file + " --frame " + frame);
  CHECK(explained.at("calibration") == learnt.at("calibration"));
}

TEST_CASE("loops are calibrated by the poses of their table", "[examples]") {
  const ScratchFolder folder;
  const std::string file = folder.path("loops.calibration");
  const std::string loops =
      "loops --nodes " + sample_map + " --min-gap 5 --false-accept-rate 0.02 ";
  const CalibrationJson learnt = calibrated_run(loops + "--calibrate --save-calibration " + file);
  const CalibrationJson& calibration = learnt.at("calibration");
  CHECK(calibration.at("source") == "null model");  // a desk teaches nothing of others
  CHECK(learnt.at("wrong") == 0);
  for (const CalibrationJson& match : learnt.at("matches")) {
    CHECK(match.at("score") >= calibration.at("threshold"));
    CHECK(match.at("confidence") < 1.0);
  }
  CHECK(calibrated_run(loops + "--calibration " + file).at("calibration") == calibration);
  const ProgramRun table = run_program(loops + "--calibration " + file + sample_options);
  CHECK(table.out.find("for a false-accept rate of 0.02 from 400 queries (null model)") !=
        std::string::npos);
}

TEST_CASE("a false-accept rate is a share, and needs no calibration", "[examples]") {
  const std::string command = "localize " + calibrated_tables;
  const CalibrationJson lenient = calibrated_run(command + " --false-accept-rate 0.5");
  const CalibrationJson strict = calibrated_run(command + " --false-accept-rate 1e-9");
  CHECK(lenient.at("accepted") > strict.at("accepted"));
  CHECK_FALSE(strict.contains("calibration"));
  CHECK(refusal(command + sample_options + "--false-accept-rate 0").find("--false-accept-rate") !=
        std::string::npos);
}

TEST_CASE("calibration options that do not fit are refused", "[examples]") {
  const std::string command = "localize --map a --query b --camera 500,500,320,240 ";
  CHECK(refusal(command + "--other-place c").find("--calibrate") != std::string::npos);
  CHECK(refusal(command + "--save-calibration c").find("--calibrate") != std::string::npos);
  CHECK(refusal(command + "--calibrate --calibration c").find("--calibrat") != std::string::npos);
  const std::string bad = sample_map + ".frames.csv";
  const std::string why =
      refusal("localize " + calibrated_tables + sample_options + "--calibration " + bad);
  CHECK(why == bad +
                   ": calibration, line 1: this is no calibration; give a file that "
                   "--save-calibration wrote");
}

TEST_CASE("a calibration of a map that repeats itself warns", "[examples]") {
  const ScratchFolder folder;
  const std::string command =
      "localize --map " + write_desk_twice(folder) + " --query " + sample_query + " --calibrate";
  const CalibrationJson calibration = calibrated_run(command).at("calibration");
  CHECK(calibration.at("repeats") > 0.02);
  REQUIRE(calibration.at("warning").is_string());
  const std::string warning = calibration.at("warning");
  CHECK(warning.find("layouts repeat, so what was learnt here may not hold elsewhere") !=
        std::string::npos);
  const ProgramRun table = run_program(command + sample_options);
  CHECK(table.out.find("  warning       " + warning + '\n') != std::string::npos);
}

TEST_CASE("a calibration is refused where graphs are made otherwise", "[examples][regression]") {
  const ScratchFolder folder;
  const std::string file = folder.path("c.txt");
  const std::string localize = "localize " + calibrated_tables + sample_options;
  REQUIRE(run_program(localize + "--calibrate --save-calibration " + file).exit_code == 0);
  const std::string again = localize + "--calibration " + file;
  CHECK(run_program(again).exit_code == 0);
  const std::string remedy =
      ": false matches of other graphs reach other scores; make them as it was learnt, or learn "
      "anew by --calibrate";
  CHECK(refusal(again + " --window 0") ==
        file + ": it was learnt with --window 3, and here it is 0" + remedy);
  CHECK(refusal(again + " --min-confidence 0.1") ==
        file + ": it was learnt with --min-confidence 0.3, and here it is 0.1" + remedy);
  CHECK(refusal(again + " --unknown-scale") ==
        file + ": it was learnt without --unknown-scale, and this run is with it" + remedy);
  CHECK(refusal("explain --frame 3 " + calibrated_tables + sample_options + "--window 1 " +
                "--calibration " + file)
            .find("with --window 3, and here it is 1") != std::string::npos);

  // What was saved before says nothing of that, and is taken.
  std::string text = program::read_file(file);
  const std::size_t begin = text.find("conditions 5\n");
  REQUIRE(begin != std::string::npos);
  const std::string last = "window 3\n";
  text.erase(begin, text.find(last, begin) + last.size() - begin);
  folder.write("before.txt", text);
  const CalibrationJson before = calibrated_run(
      "localize " + calibrated_tables + " --window 0 --calibration " + folder.path("before.txt"));
  CHECK(before.at("calibration").at("other_map").is_null());
}

TEST_CASE("a calibration of another map says so, and of how many places it was",
          "[examples][regression]") {
  const ScratchFolder folder;
  const std::string file = folder.path("c.txt"), map = folder.path("xyz.bag");
  const std::string learn =
      "localize " + calibrated_tables + " --calibrate --save-calibration " + file;
  CHECK(calibrated_run(learn).at("calibration").at("other_map") == false);
  REQUIRE(run_program("map --nodes " + sample_map + " --out " + map + sample_options).exit_code ==
          0);
  const std::string saved = "localize --map " + map + " --query " + sample_query;
  CHECK(calibrated_run(saved + " --calibration " + file).at("calibration").at("other_map") ==
        false);  // the same map in another file
  const std::string other = "localize --map " + sample_query + " --query " + sample_map;
  CHECK(calibrated_run(other + " --calibration " + file).at("calibration").at("other_map") == true);
  const std::string page = folder.path("r.html");
  const ProgramRun told =
      run_program(other + sample_options + "--calibration " + file + " --report " + page);
  CHECK(told.out.find("  learnt        with another map, of ") != std::string::npos);
  const std::string report = program::read_file(page);
  CHECK(report.find("Score asked for") != std::string::npos);
  CHECK(report.find("with another map, of ") != std::string::npos);
  CHECK(told.out.find("; this one has ") != std::string::npos);
}
