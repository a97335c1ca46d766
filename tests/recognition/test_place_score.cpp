// SPDX-License-Identifier: MIT
#include <cmath>

#include <topobag/recognition/place_score.hpp>

#include "catch.hpp"

using namespace topobag;

namespace {

/// A candidate that passed every stage, `metres` and `radians` away from the query.
CandidateReport verified(double score, double metres, double radians) {
  CandidateReport report;
  report.verdict = Verdict::not_best;
  report.similarity = 0.6;
  report.pose.emplace();
  report.pose->significance = score;
  report.pose->T_candidate_query =
      Eigen::Translation3d(0.0, metres, 0.0) * Eigen::AngleAxisd(radians, Eigen::Vector3d::UnitZ());
  return report;
}

}  // namespace

TEST_CASE("a verified candidate's place score by hand", "[recognition]") {
  CHECK(place_score(verified(1.0, 0.0, 0.0)) == Approx(0.75));
  CHECK(place_score(verified(0.0, 0.0, 0.0)) == Approx(0.5));
  CHECK(place_score(verified(3.0, 0.5, 0.0)) == Approx(0.875 * std::exp(-0.5)));
  CHECK(place_score(verified(3.0, 0.3, 0.2), {0.3, 0.1}) == Approx(0.875 * std::exp(-2.5)));
  CHECK(place_score(verified(-2.0, 0.0, 0.0)) == Approx(0.5));
}

TEST_CASE("a place score falls with the distance of the cameras and rises with the evidence",
          "[recognition]") {
  double last = 1.0;
  for (const double metres : {0.0, 0.1, 0.5, 1.0, 3.0}) {
    const double score = place_score(verified(2.0, metres, 0.0));
    CHECK(score < last);
    CHECK(score > 0.0);
    CHECK(place_score(verified(2.5, metres, 0.0)) > score);
    CHECK(place_score(verified(2.0, metres, 0.3)) < score);
    last = score;
  }
}

TEST_CASE("a candidate that is not verified scores by its similarity", "[recognition]") {
  CandidateReport report;
  report.similarity = 0.6;
  CHECK(place_score(report) == Approx(0.15));
  report = verified(9.0, 0.0, 0.0);
  for (const Verdict verdict : {Verdict::degenerate, Verdict::insignificant, Verdict::ambiguous}) {
    report.verdict = verdict;
    CHECK(place_score(report) == Approx(0.15));
  }
  report.judged_by = KeyframeId{7};  // it passed by itself
  CHECK(place_score(report) == Approx(0.95));
  report.judged_by.reset();
  report.verdict = Verdict::accepted;
  CHECK(place_score(report) == Approx(0.95));
}
