// SPDX-License-Identifier: MIT
#include "catch.hpp"
#include "error_text.hpp"
#include "recognition_run.hpp"

using namespace program;
using topobag::PoseVerdict;

namespace {

Keyframe keyframe_at(std::optional<double> x) {
  Keyframe keyframe;
  if (x) keyframe.T_world_camera = Eigen::Isometry3d(Eigen::Translation3d(*x, 0.0, 0.0));
  return keyframe;
}

/// A query that took `milliseconds` and accepted map key frame 0 at `x` m from it.
QueryRecord accepted_at(double x, double milliseconds) {
  QueryRecord record;
  topobag::CandidateReport report;
  report.pose = topobag::RelativePose{};
  report.pose->T_candidate_query = Eigen::Translation3d(x, 0.0, 0.0);
  record.recognition = {report, {report}, true};
  record.milliseconds = milliseconds;
  return record;
}

QueryRecord rejected(bool usable, bool with_candidate) {
  QueryRecord record;
  record.recognition.usable = usable;
  if (with_candidate) record.recognition.candidates.emplace_back();
  record.milliseconds = 100.0;
  return record;
}

/// Four queries at 1 m from the map's key frame, matched at 1.1, 1.5, 3 and 1 m (the last without
/// a true pose), and three that are not accepted.
RecognitionRun sample_run() {
  RecognitionRun run;
  run.map = {keyframe_at(10.0)};
  run.records = {accepted_at(1.1, 1),   accepted_at(1.5, 2),  accepted_at(3.0, 3),
                 accepted_at(1.0, 4),   rejected(true, true), rejected(true, false),
                 rejected(false, false)};
  run.queries.assign(run.records.size(), keyframe_at(11.0));
  run.queries[3] = keyframe_at(std::nullopt);
  return run;
}

}  // namespace

TEST_CASE("key frames of the map itself are counted among the queries", "[examples]") {
  RecognitionRun run = sample_run();
  CHECK(count_in_map(run) == run.queries.size());  // of one time, and all without objects
  for (std::size_t i = 0; i < run.queries.size(); ++i) run.queries[i].timestamp = double(i);
  CHECK(count_in_map(run) == 1);
  run.queries[0].graph = topobag::TopologyGraph<>(std::vector<topobag::SemanticNode<>>(2));
  CHECK(count_in_map(run) == 0);
}

TEST_CASE("a run without a query says why", "[examples]") {
  RecognitionRun run;
  run.query_set = "set";
  run.records = {rejected(true, false), rejected(false, false), rejected(false, false)};
  CHECK(error_text([&] {
          require_queries(run);
        }).find("set: none of the 3 key frames could be looked up: 2 have no usable graph, 1 ") ==
        0);
  run.before_thinning = 61;
  CHECK(error_text([&] { require_queries(run, "a key frame farther away"); }) ==
        "set: none of the 3 key frames, which --query-interval leaves of 61, could be looked up: 2 "
        "have no usable graph, 1 nothing to compare with, such as a key frame farther away");
  run.records.push_back(rejected(true, true));
  CHECK_NOTHROW(require_queries(run));
}

TEST_CASE("accepted matches are scored on three levels", "[examples]") {
  RecognitionRun run = sample_run();
  score(run, {});
  CHECK(run.records[0].verdict == PoseVerdict::correct);
  CHECK(run.records[1].verdict == PoseVerdict::imprecise);
  CHECK(run.records[2].verdict == PoseVerdict::wrong);
  CHECK_FALSE(run.records[3].verdict);
  CHECK_FALSE(run.records[4].verdict);
  const RunSummary summary = summarize(run);
  CHECK(summary.queries == 5);
  CHECK(summary.accepted == 4);
  CHECK(summary.correct == 1);
  CHECK(summary.imprecise == 1);
  CHECK(summary.wrong == 1);
  CHECK(summary.unscored == 1);
  CHECK(*summary.median_translation_error_m == Approx(0.5));
  CHECK(*summary.median_rotation_error_deg == 0.0);
  REQUIRE(summary.query_ms);  // of 1, 2, 3, 4 and 100 ms
  CHECK(summary.query_ms->median == 3.0);
  CHECK(summary.query_ms->mean == 22.0);
  CHECK(summary.query_ms->percentile_95 == 100.0);
  CHECK(summary.query_ms->worst == 100.0);
}

TEST_CASE("the limits of the scoring are the user's", "[examples]") {
  RecognitionRun run = sample_run();
  Scoring scoring;
  scoring.limits.correct_translation_m = 0.6;
  scoring.limits.wrong_translation_m = 2.5;
  score(run, scoring);
  CHECK(summarize(run).correct == 2);
  CHECK(summarize(run).wrong == 0);
}

TEST_CASE("between different places every accepted match is wrong, and has no error",
          "[examples]") {
  RecognitionRun run = sample_run();
  score(run, {{}, true, {}});
  const RunSummary summary = summarize(run);
  CHECK(summary.wrong == 4);
  CHECK(summary.accepted == 4);
  CHECK_FALSE(summary.median_translation_error_m);
}

TEST_CASE("an even number of values has the mean of the middle two as median", "[examples]") {
  RecognitionRun run = sample_run();
  run.records.resize(4);
  CHECK(summarize(run).query_ms->median == 2.5);
  run.records.clear();
  CHECK_FALSE(summarize(run).query_ms);
}

TEST_CASE("95 % of the queries took no longer than the 95th of 100", "[examples]") {
  RecognitionRun run;
  for (int ms = 100; ms >= 1; --ms) run.records.push_back(accepted_at(0.0, ms));
  CHECK(summarize(run).query_ms->percentile_95 == 95.0);
  run.records.push_back(accepted_at(0.0, 101));
  CHECK(summarize(run).query_ms->percentile_95 == 96.0);
}

TEST_CASE("a match of cameras farther apart than the place is wide is wrong", "[examples]") {
  RecognitionRun run = sample_run();  // cameras 1 m apart
  run.queries[3] = keyframe_at(11.0);
  Scoring scoring;
  scoring.place_radius = 1.1;
  score(run, scoring);
  CHECK(run.records[0].verdict == PoseVerdict::correct);
  scoring.place_radius = 0.9;
  score(run, scoring);
  CHECK(summarize(run).wrong == 4);
  CHECK(run.records[0].error);  // which is told all the same
  run.queries[3] = keyframe_at(std::nullopt);
  CHECK(error_text([&] { score(run, scoring); }).find("has no pose, which --place-radius needs") !=
        std::string::npos);
}

TEST_CASE("of two worlds the motion is taken that most matches agree on", "[examples]") {
  RecognitionRun run = sample_run();
  // The queries' world lies 5 m behind the map's and is turned; two of the three say so.
  const Eigen::Isometry3d T =
      Eigen::Translation3d(5.0, 0.0, 0.0) * Eigen::AngleAxisd(1.0, Eigen::Vector3d::UnitZ());
  for (Keyframe& query : run.queries) {
    if (query.T_world_camera) query.T_world_camera = T.inverse() * *query.T_world_camera;
  }
  Scoring scoring;
  scoring.align_worlds = true;
  run.records[1] = accepted_at(1.2, 2);  // beside 1.1 and 3 m
  score(run, scoring);
  REQUIRE(run.T_map_query_world);
  CHECK(summarize(run).correct == 2);
  CHECK(summarize(run).wrong == 1);
  CHECK(run.records[0].error->translation_m == Approx(0.0).margin(1e-9));  // it is the first's
  const Eigen::Isometry3d off = run.T_map_query_world->inverse() * T;
  CHECK(off.translation().norm() == Approx(0.1));
  CHECK_FALSE(aligned_worlds(RecognitionRun{}, {}));
}
