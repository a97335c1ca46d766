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

TEST_CASE("a map's own key frames are no other place", "[examples][regression]") {
  const std::string tables =
      "localize --map " + sample_map + " --query " + sample_query + sample_options;
  CHECK(refusal(tables + "--calibrate --other-place " + sample_map) ==
        "--other-place: 67 of its 67 key frames are the map's own, which are no other place");
}

TEST_CASE("a vertical that the map lacks is told", "[examples][regression]") {
  const ScratchFolder folder;
  const std::string map = folder.path("map.bag");
  REQUIRE(run_program("map --nodes " + sample_map + sample_options + "--out " + map).exit_code ==
          0);
  const std::string told = "the map knows of none, so that --world-up changes nothing";
  const std::string up = " --query " + sample_query + sample_options + "--world-up 0,0,1";
  CHECK(run_program("localize --map " + map + up).out.find(told) != std::string::npos);
  CHECK(run_program("localize --map " + sample_map + up).out.find(told) == std::string::npos);
}

TEST_CASE("boxes outside the image are told with the option of their table",
          "[examples][regression]") {
  const ScratchFolder folder;
  folder.write("s.frames.csv", "idx,frame,timestamp\n0,a,0\n");
  folder.write("s.nodes.csv", "idx,class,conf,u,v,w,h,z\n0,cup,1,800,100,20,20,2\n");
  const std::string wide = folder.path("s"), options = sample_options + "--window 0 ";
  CHECK(refusal("localize --map " + wide + " --query " + sample_query + options)
            .find("; give --map-camera with its width and height of the table's images") !=
        std::string::npos);
  CHECK(refusal("localize --map " + sample_map + " --query " + wide + options)
            .find("; give --camera and --image-size of the table's images") != std::string::npos);
}
