// SPDX-License-Identifier: MIT
#include "run_conditions.hpp"

#include <string>

#include <nlohmann/json.hpp>

#include "catch.hpp"
#include "run_program.hpp"
#include "sample.hpp"

namespace {

/// A run of accepted matches, each of which is estimated exactly, and a camera's distances.
program::RecognitionRun run_apart(const std::vector<double>& distances) {
  program::RecognitionRun run;
  program::Keyframe map;
  map.T_world_camera = Eigen::Isometry3d::Identity();
  run.map = {map};
  for (const double x : distances) {
    program::Keyframe query;
    query.T_world_camera = Eigen::Isometry3d(Eigen::Translation3d(x, 0.0, 0.0));
    topobag::CandidateReport report;
    report.pose = topobag::RelativePose{};
    report.pose->T_candidate_query = *query.T_world_camera;
    program::QueryRecord record;
    record.recognition = {report, {report}, true};
    run.queries.push_back(query);
    run.records.push_back(record);
  }
  return run;
}

const std::string conditions_tables =
    "localize --map " + sample_map + " --query " + sample_query + sample_options;

}  // namespace

TEST_CASE("what a radius makes wrong is counted beside what the pose does",
          "[examples][regression]") {
  program::RecognitionRun run = run_apart({0.1, 0.3, 0.5, 3.0});
  run.records[3].recognition.accepted->pose->T_candidate_query.setIdentity();  // 3 m off
  program::Scoring scoring;
  program::score(run, scoring);
  CHECK(program::wrong_text(run) == "beyond 1 m or 45°");
  CHECK(program::conditions_json(run).empty());
  scoring.place_radius = 0.2;
  program::score(run, scoring);
  CHECK(program::summarize(run).wrong == 3);
  CHECK(program::wrong_text(run) ==
        "beyond 1 m or 45°, or of cameras more than 0.2 m apart (2 by that alone)");
  CHECK(program::conditions_json(run) ==
        program::Json{{"place_radius_m", 0.2}, {"wrong_by_radius", 2}});
  scoring = {};
  scoring.different_places = true;
  program::score(run, scoring);
  CHECK(program::wrong_text(run) == "wherever accepted: the sequences share no place");
  CHECK(program::conditions_json(run) == program::Json{{"different_places", true}});
}

TEST_CASE("key frames that are left out are counted", "[examples][regression]") {
  program::RecognitionRun run = run_apart({0.0, 1.0, 2.0, 3.0});
  for (std::size_t i = 0; i < 4; ++i) run.queries[i].timestamp = double(i);
  CHECK(program::left_out_text(run).empty());
  program::thin_queries(run, 2.0);
  CHECK(run.queries.size() == 2);
  CHECK(program::left_out_text(run) == "2 of 4 queries, nearer than 2 s to the one before");
  run.leave_out_radius = 0.5;
  run.left_out_of_map = 1;
  CHECK(program::left_out_text(run) ==
        "2 of 4 queries, nearer than 2 s to the one before; 0.5 of the map's 1 key frames in the "
        "mean of the queries, within 0.5 m of each");
}

TEST_CASE("the text, the JSON and the page name radius and interval", "[examples][regression]") {
  const ScratchFolder folder;
  const std::string options = "--place-radius 0.2 --leave-out-radius 0.05 --query-interval 1 ";
  const ProgramRun told =
      run_program(conditions_tables + options + "--json --report " + folder.path("r.html"));
  CAPTURE(told.err);
  REQUIRE(told.exit_code == 0);
  const nlohmann::json json = nlohmann::json::parse(told.out);
  CHECK(json.at("place_radius_m") == 0.2);
  CHECK(json.at("leave_out_radius_m") == 0.05);
  CHECK(json.at("query_interval_s") == 1.0);
  CHECK(json.at("keyframes").get<int>() + json.at("queries_left_out").get<int>() == 61);
  CHECK(json.at("queries_left_out") > 0);
  CHECK(json.at("map_keyframes_left_out") > 0.0);
  CHECK(json.at("wrong_by_radius") <= json.at("wrong"));
  const std::string page = program::read_file(folder.path("r.html"));
  const std::string wrong = "or of cameras more than 0.2 m apart (" +
                            std::to_string(json.at("wrong_by_radius").get<int>()) +
                            " by that alone)";
  CHECK(page.find(wrong) != std::string::npos);
  CHECK(page.find("more than 0.2 m from the query&#39;s camera") != std::string::npos);
  CHECK(page.find("pose alone") == std::string::npos);
  CHECK(page.find("within 0.05 m of each") != std::string::npos);
  const std::string text = run_program(conditions_tables + options).out;
  CHECK(text.find(wrong) != std::string::npos);
  CHECK(text.find("\nleft out: ") != std::string::npos);
}
