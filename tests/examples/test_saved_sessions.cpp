// SPDX-License-Identifier: MIT
// A saved map's sessions, as the decision sees them.
#include <cstddef>
#include <sstream>
#include <string>

#include <nlohmann/json.hpp>

#include "catch.hpp"
#include "csv_reader.hpp"
#include "run_program.hpp"
#include "sample.hpp"

namespace {

/// The first ten frames of the sample's map without their poses, some seconds later.
std::string write_ten_frames(const ScratchFolder& folder, const std::string& name, double later) {
  const std::string set = folder.path(name);
  const auto first_ten = [&](const std::string& kind, const auto& changed) {
    std::istringstream lines(program::read_file(sample_map + kind));
    std::string text, line;
    std::getline(lines, line);
    for (text = changed(line) + '\n'; std::getline(lines, line) && std::stoi(line) < 10;) {
      text += changed(line) + '\n';
    }
    program::write_file(set + kind, text);
  };
  first_ten(".nodes.csv", [](const std::string& line) { return line; });
  first_ten(".frames.csv", [&](const std::string& line) {
    const std::size_t frame = line.find(',') + 1, time = line.find(',', frame) + 1;
    const std::string stamp = line.substr(time, line.find(',', time) - time);
    return line.substr(0, time) +
           (stamp == "timestamp" ? stamp : std::to_string(std::stod(stamp) + later));
  });
  return set;
}

nlohmann::json told_by(const std::string& arguments) {
  const ProgramRun run = run_program(arguments + sample_options + " --window 0 --json");
  CAPTURE(arguments, run.err);
  REQUIRE(run.exit_code == 0);
  return nlohmann::json::parse(run.out);
}

}  // namespace

TEST_CASE("key frames without poses of two sessions are of two places", "[examples][regression]") {
  const ScratchFolder folder;
  const std::string once = folder.path("once.bag"), twice = folder.path("twice.bag");
  const auto map = [&](const std::string& file, const std::string& table) {
    const ProgramRun run =
        run_program("map --append --nodes " + table + sample_options + "--window 0 --out " + file);
    CAPTURE(run.err);
    REQUIRE(run.exit_code == 0);
  };
  const std::string today = write_ten_frames(folder, "today", 0.0);
  map(once, today);
  map(twice, today);
  map(twice, write_ten_frames(folder, "later", 1000.0));
  const auto best = [&](const std::string& file) {
    const std::string tables = "explain --map " + file + " --query " + sample_map;
    return told_by(tables + " --frame 4").at("candidates").at(0);
  };
  CHECK(best(once).at("verdict") == "accepted");
  // The ids are near each other, as those of neighbours; but nothing tells that the sessions are.
  const nlohmann::json refused = best(twice);
  CHECK(refused.at("verdict") == "another place fits about as well");
  CHECK(refused.at("rival_map_session") == 1 - refused.at("map_session").get<int>());
  CHECK(refused.at("rival_pose_candidate_query").size() == 7);
  CHECK_FALSE(refused.contains("rival_pose_world_query"));
  const auto places = [&](const std::string& file) {
    const std::string tables = "localize --map " + file + " --query " + sample_map;
    return told_by(tables + " --calibrate").at("calibration").at("places");
  };
  // What a session passes within some seconds is a place, or two where these begin anew.
  CHECK(places(once) <= 2);
  CHECK(places(twice) > places(once));
}
