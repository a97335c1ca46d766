// SPDX-License-Identifier: MIT
// The reports of the commands, written by the program.
#include <algorithm>
#include <set>

#include <nlohmann/json.hpp>

#include "catch.hpp"
#include "examples/report/page_text.hpp"
#include "examples/run_program.hpp"
#include "examples/sample.hpp"
#include "report/query_outcome.hpp"

using nlohmann::json;

namespace {

struct WrittenReport {
  std::string page;
  json data;

  bool has(const std::string& figure) const { return data.at("figures").contains(figure); }
};

WrittenReport report_of(const std::string& arguments) {
  const ScratchFolder folder;
  const ProgramRun run = run_program(arguments + " --report " + folder.path("r.html") +
                                     " --report-data " + folder.path("r.json"));
  CAPTURE(run.err);
  REQUIRE(run.exit_code == 0);
  return {program::read_file(folder.path("r.html")),
          json::parse(program::read_file(folder.path("r.json")))};
}

const std::string localize =
    "localize --map " + sample_map + " --query " + sample_query + sample_options;

/// Four key frames at x = 0, 0.1, 9 and 9.1 m, 10 s apart.
const std::string poses =
    "0 0 0 0 0 0 0 1\n10 0.1 0 0 0 0 0 1\n20 9 0 0 0 0 0 1\n30 9.1 0 0 0 0 0 1\n";

}  // namespace

TEST_CASE("the report of localize is one page of all figures", "[examples][report]") {
  const ScratchFolder folder;
  const std::string pairs = folder.path("pairs.csv");
  const WrittenReport report = report_of(localize + " --pairs " + pairs);
  CHECK(references(report.page).empty());
  CHECK(times(report.page, "<figure ") == report.data.at("figures").size());
  for (const char* figure :
       {"trajectory", "precision-recall", "recall-at-k", "match-scores", "similarities",
        "similarity-matrix", "score-matrix", "verdicts", "translation-error", "rotation-error",
        "by-angle", "by-overlap", "by-objects", "by-gap", "match-best", "match-worst"}) {
    CAPTURE(figure);
    CHECK(report.has(figure));
  }
  CHECK(report.page.find(program::default_protocol) != std::string::npos);
  const json& rows = report.data.at("figures").at("similarity-matrix").at("rows");
  CHECK(times(program::read_file(pairs), "\n") == rows.size() + 1);
}

TEST_CASE("a report counts as the command does", "[examples][report]") {
  const ScratchFolder folder;
  const ProgramRun run =
      run_program(localize + " --json --report-data " + folder.path("report.json"));
  REQUIRE(run.exit_code == 0);
  const json counted = json::parse(run.out);
  const json data = json::parse(program::read_file(folder.path("report.json")));
  std::size_t correct = 0;
  for (const json& row : data.at("figures").at("trajectory").at("rows")) {
    if (row.at(4) == "correct") ++correct;
  }
  CHECK(correct == counted.at("correct"));
  CHECK(correct > 0);
}

TEST_CASE("the curve of a report says what its verdicts say", "[examples][report]") {
  const ScratchFolder folder;
  const ProgramRun run = run_program(localize + " --json --report-data " + folder.path("r.json"));
  REQUIRE(run.exit_code == 0);
  const json counted = json::parse(run.out);
  const json figures = json::parse(program::read_file(folder.path("r.json"))).at("figures");
  REQUIRE(counted.at("wrong") == 0);
  double least = 1e300, recall = 0.0;
  for (const json& match : counted.at("matches")) {
    least = std::min(least, match.at("score").get<double>());
  }
  for (const json& row : figures.at("precision-recall").at("rows")) {
    if (row.at(1) < least) continue;
    CHECK(row.at(3) == 1.0);  // what was accepted is right
    recall = std::max(recall, row.at(2).get<double>());
  }
  CHECK(recall > 0.8);
}

TEST_CASE("a report declares another protocol when asked to", "[examples][report]") {
  const WrittenReport report = report_of(localize + " --protocol distance=0.5,angle=30");
  CHECK(report.page.find("distance=0.5,angle=30") != std::string::npos);
  CHECK(report.has("by-angle"));
}

TEST_CASE("without true places a report draws what needs none", "[examples][report]") {
  const WrittenReport report = report_of(localize + " --different-places");
  CHECK(report.page.find("share no place") != std::string::npos);
  CHECK_FALSE(report.has("trajectory"));
  CHECK_FALSE(report.has("precision-recall"));
  CHECK(report.has("similarity-matrix"));
  CHECK(report.has("match-wrong-1"));
}

TEST_CASE("the report of loops asks for the gap alone", "[examples][report]") {
  const WrittenReport report =
      report_of("loops --nodes " + sample_map + sample_options + " --min-gap 5");
  CHECK(references(report.page).empty());
  CHECK(report.page.find("exclude-seconds=5,past-only") != std::string::npos);
  CHECK(report.has("trajectory"));
  const WrittenReport declared = report_of("loops --nodes " + sample_map + sample_options +
                                           " --min-gap 5 --protocol distance=0.5,angle=30");
  CHECK(declared.page.find("distance=0.5,angle=30,exclude-seconds=5,past-only") !=
        std::string::npos);
}

TEST_CASE("the report of evaluate: accepted, missed and wrong answers", "[examples][report]") {
  const ScratchFolder folder;
  const std::string files =
      "evaluate --poses " + folder.write("poses.txt", poses) + " --scores " +
      folder.write("scores.csv", "nan,.9,.8,.1\n.9,nan,.2,.1\n.8,.2,nan,.7\n.1,.1,.6,nan\n") +
      " --protocol distance=1";
  const auto outcomes = [&](const std::string& options) {
    const WrittenReport report = report_of(files + options);
    CHECK(references(report.page).empty());
    CHECK(times(report.page, "<figure ") >= 6);
    std::vector<std::string> found;
    for (const json& row : report.data.at("figures").at("trajectory").at("rows")) {
      found.push_back(row.at(4));
    }
    return found;
  };
  CHECK(outcomes(" --accept 0.65") ==
        std::vector<std::string>{"correct", "correct", "wrong", "missed"});
  CHECK(outcomes(" --accept 0") ==
        std::vector<std::string>{"correct", "correct", "wrong", "correct"});
}

TEST_CASE("evaluate accepts every pair by default where lower is better", "[examples][report]") {
  const ScratchFolder folder;
  const std::string files = "evaluate --json --lower-is-better --poses " +
                            folder.write("poses.txt", poses) + " --scores " +
                            folder.write("loops.csv",
                                         "query,candidate,score,tx,ty,tz,qx,qy,qz,qw\n"
                                         "1,0,1,0.1,0,0,0,0,0,1\n3,2,2,0.6,0,0,0,0,0,1\n") +
                            " --protocol distance=1,past-only";
  CHECK(json::parse(run_program(files).out).at("loops").at("accepted") == 2);
  CHECK(json::parse(run_program(files + " --accept 1").out).at("loops").at("accepted") == 1);
}

TEST_CASE("the report of evaluate says that nothing is accepted", "[examples][report]") {
  const ScratchFolder folder;
  const std::string scores = "nan,.1,.8,.9\n.1,nan,.9,.8\n.8,.9,nan,.1\n.9,.8,.1,nan\n";
  const std::string files = "evaluate --poses " + folder.write("poses.txt", poses) + " --scores " +
                            folder.write("scores.csv", scores) + " --protocol distance=";
  for (const std::string distance :
       {"0.01", "1"}) {  // no true pair, and none that is a best answer
    const std::string page = report_of(files + distance).page;
    CHECK(page.find("none: no query&#39;s best answer is true") != std::string::npos);
  }
}
