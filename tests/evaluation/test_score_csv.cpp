// SPDX-License-Identifier: MIT
#include <cmath>
#include <sstream>

#include <topobag/evaluation/score_csv.hpp>

#include "catch.hpp"
#include "error_text.hpp"

using namespace topobag;

namespace {

std::variant<ScoreMatrix, ScoreList> scores_in(const std::string& text) {
  std::istringstream stream(text);
  return read_score_csv(stream, "scores.csv");
}

std::string scores_complaint(const std::string& text) {
  return error_text([&] { scores_in(text); });
}

}  // namespace

TEST_CASE("a matrix, a row per query", "[evaluation]") {
  const auto scores = std::get<ScoreMatrix>(scores_in("# cosine\n1, 0.5,-2e-3\r\n0.25,nan,1\n"));
  REQUIRE(scores.rows() == 2);
  REQUIRE(scores.cols() == 3);
  CHECK(scores(0, 2) == -0.002);
  CHECK(scores(1, 0) == 0.25);
  CHECK(std::isnan(scores(1, 1)));
}

TEST_CASE("a list of pairs, with and without relative poses", "[evaluation]") {
  const auto plain = std::get<ScoreList>(scores_in("query,candidate,score\n7,3,0.5\n8,0,1\n"));
  REQUIRE(plain.pairs.size() == 2);
  CHECK(plain.pairs[0].query == 7);
  CHECK(plain.pairs[0].candidate == 3);
  CHECK(plain.pairs[1].score == 1.0);
  CHECK(plain.T_candidate_query.empty());
  const auto posed = std::get<ScoreList>(
      scores_in("query,candidate,score,tx,ty,tz,qx,qy,qz,qw\n7,3,0.5,1,2,3,0,0,0,1\n"));
  REQUIRE(posed.T_candidate_query.size() == 1);
  CHECK(posed.T_candidate_query[0].translation() == Eigen::Vector3d(1, 2, 3));
  CHECK(std::get<ScoreList>(scores_in("query,candidate,score\n")).pairs.empty());
}

TEST_CASE("what is neither is refused with file and line", "[evaluation]") {
  CHECK(scores_complaint("") == "scores.csv holds no scores.");
  CHECK(scores_complaint("1,2\n1\n").find("scores.csv:2: ") == 0);
  CHECK(scores_complaint("1,2\n1,x\n").find("'x' is not a number") != std::string::npos);
  CHECK(scores_complaint("1,2\n1,,2\n").find("a number is missing") != std::string::npos);
  CHECK(scores_complaint("1,2\n1,2,\n").find("a number is missing") != std::string::npos);
  CHECK(scores_complaint("query,match,score\n").find(":1: the header") != std::string::npos);
  CHECK(scores_complaint("query,candidate,score\n1,2\n").find(":2: ") != std::string::npos);
  CHECK(scores_complaint("query,candidate,score\n-1,2,0\n").find("row numbers") !=
        std::string::npos);
  CHECK(scores_complaint("query,candidate,score\n1,2.5,0\n").find("row numbers") !=
        std::string::npos);
  CHECK(scores_complaint("query,candidate,score\n1,nan,0\n").find("row numbers") !=
        std::string::npos);
  CHECK(scores_complaint("query,candidate,score,tx,ty,tz,qx,qy,qz,qw\n1,2,0,0,0,0,0,0,0,2\n")
            .find("unit length") != std::string::npos);
}
