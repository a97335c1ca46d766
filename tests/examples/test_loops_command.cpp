// SPDX-License-Identifier: MIT
#include <algorithm>
#include <map>

#include <nlohmann/json.hpp>

#include "catch.hpp"
#include "node_table.hpp"
#include "run_program.hpp"
#include "sample.hpp"

namespace {

nlohmann::json loops(const std::string& options) {
  const ProgramRun run =
      run_program("loops --nodes " + sample_map + sample_options + " --json " + options);
  CAPTURE(run.err);
  REQUIRE(run.exit_code == 0);
  return nlohmann::json::parse(run.out);
}

}  // namespace

TEST_CASE("a loop goes to a key frame that is at least the gap older", "[examples]") {
  std::map<std::int64_t, double> stamps;
  for (const auto& frame : program::read_node_table(sample_map).frames) {
    stamps[frame.idx] = frame.timestamp;
  }
  for (const double gap : {5.0, 15.0}) {
    const auto report = loops("--min-gap " + std::to_string(gap));
    CHECK(report.at("keyframes") == 67);
    CHECK(report.at("accepted") > 0);
    CHECK(report.at("wrong") == 0);
    for (const auto& match : report.at("matches")) {
      CHECK(stamps.at(match.at("query_idx")) - stamps.at(match.at("map_idx")) >= gap);
    }
    for (const auto& [idx, stamp] : stamps) {
      if (stamp - stamps.begin()->second >= gap) continue;
      for (const auto& match : report.at("matches")) CHECK(match.at("query_idx") != idx);
    }
  }
}

TEST_CASE("a gap longer than the sequence leaves no query, which is an error", "[examples]") {
  CHECK(refusal("loops --nodes " + sample_map + sample_options + " --min-gap 1000") ==
        sample_map +
            ": none of the 67 key frames could be looked up: 0 have no usable graph, 67 nothing to "
            "compare with, such as a key frame that is older by --min-gap");
}

TEST_CASE("a bad gap ends loops with one line", "[examples]") {
  refusal("loops --nodes a --camera 500,500,320,240 --min-gap -1");
  refusal("loops --nodes a --camera 500,500,320,240 --min-gap nan");
}

TEST_CASE("loops draws the best loop, and looks for some key frames alone", "[examples]") {
  const ScratchFolder folder;
  const auto all = loops("--min-gap 5 --svg " + folder.path("loop.svg"));
  CHECK(program::read_file(folder.path("loop.svg")).find("<svg ") == 0);
  const auto some = loops("--min-gap 5 --query-interval 1");
  CHECK(some.at("map_keyframes") == all.at("map_keyframes"));
  CHECK(some.at("queries") < all.at("queries"));
  for (const auto& match : some.at("matches")) {
    const auto& matches = all.at("matches");
    CHECK(std::find(matches.begin(), matches.end(), match) != matches.end());
  }
}
