// SPDX-License-Identifier: MIT
#include <topobag/recognition/recognition.hpp>

#include "catch.hpp"

using namespace topobag;

TEST_CASE("the margin is what the score has over the threshold", "[recognition]") {
  CandidateReport report;
  report.threshold = 2.0;
  CHECK(report.margin() == -2.0);  // without a pose
  report.pose = RelativePose{};
  report.pose->significance = 5.0;
  report.pose->missing_cost = 0.5;
  CHECK(report.margin() == 2.5);
}

TEST_CASE("a recognition is true when a candidate was accepted", "[recognition]") {
  Recognition recognition;
  CHECK_FALSE(recognition);
  recognition.candidates.emplace_back();
  CHECK_FALSE(recognition);
  recognition.accepted = recognition.candidates.front();
  CHECK(recognition);
}
