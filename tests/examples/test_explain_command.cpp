// SPDX-License-Identifier: MIT
#include <string>

#include <nlohmann/json.hpp>

#include "catch.hpp"
#include "csv_reader.hpp"
#include "desk_twice.hpp"
#include "run_program.hpp"
#include "sample.hpp"

namespace {

using Json = nlohmann::json;

const std::string sample_tables = "--map " + sample_map + " --query " + sample_query;

Json json_of(const std::string& arguments) {
  const ProgramRun run = run_program(arguments + sample_options + " --json");
  CAPTURE(arguments, run.err);
  REQUIRE(run.exit_code == 0);
  return Json::parse(run.out);
}

Json explanation_of(int frame, const std::string& options = "") {
  return json_of("explain " + sample_tables + " --frame " + std::to_string(frame) + options);
}

/// A frame that `localize` accepts, and the map's it goes to.
Json accepted_match() { return json_of("localize " + sample_tables).at("matches").at(0); }

}  // namespace

TEST_CASE("explain says of every candidate what localize decided, and why", "[examples]") {
  const Json match = accepted_match();
  const Json explanation = explanation_of(match.at("query_idx"));
  CHECK(explanation.at("usable") == true);
  CHECK(explanation.at("candidates").size() > 60);
  std::size_t accepted = 0;
  for (const Json& candidate : explanation.at("candidates")) {
    bool failed = false;
    for (const Json& stage : candidate.at("stages")) failed |= !stage.at("passed").get<bool>();
    CHECK(failed == (candidate.at("verdict") != "accepted"));
    if (failed) continue;
    ++accepted;
    CHECK(candidate.at("map_idx") == match.at("map_idx"));
    CHECK(candidate.at("matched").size() >= 3);
  }
  CHECK(accepted == 1);
}

TEST_CASE("explain tells a reader of the best candidates", "[examples]") {
  const int frame = accepted_match().at("query_idx");
  const ProgramRun run = run_program("explain " + sample_tables + sample_options +
                                     " --candidates 2 --frame " + std::to_string(frame));
  CHECK(run.exit_code == 0);
  CHECK(run.out.find("accepted") != std::string::npos);
  CHECK(run.out.find("passed  score") != std::string::npos);
  CHECK(run.out.find("more candidates") != std::string::npos);
}

TEST_CASE("explain draws the candidate", "[examples]") {
  const ScratchFolder folder;
  const Json match = accepted_match();
  explanation_of(match.at("query_idx"), " --svg " + folder.path("c.svg"));
  const std::string drawing = program::read_file(folder.path("c.svg"));
  CHECK(drawing.find("<svg ") == 0);
  CHECK(drawing.find("nan") == std::string::npos);
  CHECK(drawing.find("query, idx " + std::to_string(match.at("query_idx").get<int>())) !=
        std::string::npos);
}

TEST_CASE("a frame that is no key frame is refused with what to do", "[examples]") {
  CHECK(refusal("explain " + sample_tables +
                " --camera 517.3,516.5,318.6,255.3 --keyframe-interval 5 --frame 3") ==
        "--frame 3: no key frame of the query has this idx; --keyframe-interval 0 takes all "
        "frames");
}

TEST_CASE("a frame that is not in the table is refused with what is", "[examples][regression]") {
  for (const std::string frame : {"500", "-1"}) {
    CHECK(refusal("explain " + sample_tables + sample_options + " --frame " + frame) ==
          "--frame " + frame + ": the table has no frame of this idx; it has idx 0 to 60");
  }
}

TEST_CASE("no candidate to print is refused", "[examples][regression]") {
  CHECK(refusal("explain " + sample_tables + sample_options + " --frame 3 --candidates 0") ==
        "--candidates: '0' is not a whole number in [1, inf); see topobag explain --help");
}

TEST_CASE("a key frame of a saved map is told by session and frame", "[examples]") {
  const ScratchFolder folder;
  const std::string map = folder.path("map.bag");
  for (const std::string& table : {sample_map, sample_query}) {
    const ProgramRun run =
        run_program("map --append --nodes " + table + sample_options + "--out " + map);
    REQUIRE(run.exit_code == 0);
  }
  const std::string tables = "--map " + map + " --query " + sample_query;
  const Json matches = json_of("localize " + tables).at("matches");
  REQUIRE(matches.size() > 0);
  const Json& match = matches.at(0);  // itself, the second session's
  CHECK(match.at("map_session") == 1);
  CHECK(match.at("map_idx") == match.at("query_idx"));
  CHECK(match.at("map_id") == 67 + match.at("query_idx").get<int>());
  const std::string frame = std::to_string(match.at("query_idx").get<int>());
  const ProgramRun told = run_program("explain " + tables + sample_options + " --frame " + frame);
  CHECK(told.out.find("map session 1, idx " + frame + ": accepted") != std::string::npos);
  const ProgramRun lines = run_program("localize --verbose " + tables + sample_options);
  CHECK(lines.out.find("accepted, map session 1, idx " + frame + ", score ") != std::string::npos);
}

TEST_CASE("explain tells where another place that fits as well puts the query", "[examples]") {
  const ScratchFolder folder;
  const std::string tables = "--map " + write_desk_twice(folder) + " --query " + sample_query;
  const std::string frame = " --frame " + accepted_match().at("query_idx").dump();
  const Json candidate = json_of("explain " + tables + frame).at("candidates").at(0);
  CHECK(candidate.at("verdict") == "another place fits about as well");
  CHECK((candidate.at("map_idx") < 1000) == (candidate.at("rival_map_idx") >= 1000));
  CHECK(candidate.at("rival_pose_candidate_query").size() == 7);
  const Json pose = candidate.at("rival_pose_world_query");
  REQUIRE(pose.size() == 7);
  const bool aside = candidate.at("rival_map_idx") >= 1000;
  CHECK(pose.at(0).get<double>() == Approx(aside ? 51.3 : 1.3).margin(0.3));  // the desk's cameras
  const ProgramRun run = run_program("explain " + tables + sample_options + frame);
  CHECK(run.out.find(", with the query at (" + std::string(aside ? "5" : "1")) !=
        std::string::npos);
}
