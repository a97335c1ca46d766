// SPDX-License-Identifier: MIT
// Which key frames are looked up, among which, and what they are held against.
#include <algorithm>

#include <nlohmann/json.hpp>

#include "catch.hpp"
#include "node_table.hpp"
#include "run_program.hpp"
#include "sample.hpp"

namespace {

using LookedUp = nlohmann::json;

LookedUp looked_up(const std::string& options) {
  const ProgramRun run = run_program("localize --map " + sample_map + " --query " + sample_query +
                                     sample_options + " --json " + options);
  CAPTURE(run.err);
  REQUIRE(run.exit_code == 0);
  return LookedUp::parse(run.out);
}

}  // namespace

TEST_CASE("an interval thins the queries alone", "[examples]") {
  const LookedUp all = looked_up(""), some = looked_up("--query-interval 1");
  CHECK(some.at("map_keyframes") == all.at("map_keyframes"));
  CHECK(some.at("keyframes") < 0.5 * all.at("keyframes").get<double>());
  for (const LookedUp& match : some.at("matches")) {  // each as without
    const LookedUp& matches = all.at("matches");
    CHECK(std::find(matches.begin(), matches.end(), match) != matches.end());
  }
}

TEST_CASE("without the key frames around it a query is found farther away, or not at all",
          "[examples]") {
  const double radius = 0.2;
  const std::string leave_out = "--leave-out-radius " + std::to_string(radius);
  const LookedUp all = looked_up("");
  CHECK(looked_up("--leave-out-radius 0").at("matches") == all.at("matches"));
  CHECK(looked_up(leave_out).at("matches") != all.at("matches"));
  CHECK(looked_up(leave_out + " --place-radius " + std::to_string(radius)).at("correct") == 0);
  CHECK(looked_up("--place-radius 100").at("correct") == all.at("correct"));
}

TEST_CASE("poses come from a trajectory where one is given", "[examples]") {
  const ScratchFolder folder;
  program::NodeTable query = program::read_node_table(sample_query);
  for (program::FrameRow& frame : query.frames) frame.T_world_camera.reset();
  program::write_node_table(folder.path("bare"), query);
  const std::string arguments =
      "localize --json --map " + sample_map + " --query " + folder.path("bare") + sample_options;
  const ProgramRun run = run_program(arguments + "--trajectory " + sample_query + ".frames.csv");
  CAPTURE(run.err);
  REQUIRE(run.exit_code == 0);
  const LookedUp given = LookedUp::parse(run.out), own = looked_up("");
  CHECK(given.at("accepted") == own.at("accepted"));
  CHECK(given.at("correct") == own.at("correct"));
  CHECK(refusal(arguments + "--leave-out-radius 1 --window 0").find("has no pose") !=
        std::string::npos);
}

TEST_CASE("a table without a graph to match is refused with the reasons, whatever the window",
          "[examples]") {
  for (const std::string window : {"0", "3"}) {
    const std::string said = refusal("localize --map " + sample_map + " --query " + sample_query +
                                     sample_options + "--min-confidence 1 --window " + window);
    CHECK(said.find("none of the 67 key frames has three objects with a position; of 772 "
                    "detections in the table 772 are below --min-confidence") != std::string::npos);
  }
}
