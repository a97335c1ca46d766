// SPDX-License-Identifier: MIT
#include "recognition_report.hpp"

#include <string>

#include "catch.hpp"

TEST_CASE("a key frame's line tells a score from what was asked of it", "[examples][regression]") {
  program::RecognitionRun run;
  run.map.emplace_back();
  run.queries.emplace_back();
  topobag::CandidateReport report;
  report.id = topobag::KeyframeId{0};
  report.pose = topobag::RelativePose{};
  report.verdict = topobag::Verdict::insignificant;
  program::QueryRecord record;
  record.recognition.usable = true;
  const auto line = [&](double threshold) {
    report.threshold = threshold;
    record.recognition.candidates = {report};
    run.records = {record};
    return program::to_lines(run);
  };
  report.pose->viewpoint_odds += 1.75 - report.score();
  CHECK(line(1.7504).find(", score 1.7500 of 1.7504,") != std::string::npos);
  CHECK(line(2.15).find(", score 1.75 of 2.15,") != std::string::npos);
}
