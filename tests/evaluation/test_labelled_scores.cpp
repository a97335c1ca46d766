// SPDX-License-Identifier: MIT
#include <limits>

#include <topobag/evaluation/labelled_scores.hpp>

#include "catch.hpp"
#include "evaluation/random_scores.hpp"

using namespace topobag;
using topobag_tests::planar_pose;
using topobag_tests::random_scored_places;

namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

/// At 0, 0, 2 and 10 m; positive up to 1 m, negative from 5 m on.
PlaceTruth four_places() {
  PlaceProtocol protocol;
  protocol.distance_m = 1.0;
  protocol.negative_distance_m = 5.0;
  return {protocol,
          {{0.0, planar_pose(0, 0, 0)},
           {1.0, planar_pose(0, 0, 0)},
           {2.0, planar_pose(2, 0, 0)},
           {3.0, planar_pose(10, 0, 0)}}};
}

}  // namespace

TEST_CASE("only positive and negative pairs have a label", "[evaluation]") {
  ScoreMatrix scores(4, 4);
  scores << nothing, 0.9, nothing, 0.1,  //
      0.8, nothing, nothing, 0.9,        //
      nothing, nothing, nothing, 0.3,    //
      0.2, 0.2, 0.4, nothing;
  const LabelledScores labelled = label_scores(scores, four_places());
  REQUIRE(labelled.scores.size() == 8);
  const double falling[] = {0.9, 0.9, 0.8, 0.4, 0.3, 0.2, 0.2, 0.1};
  for (std::size_t i = 0; i < 8; ++i) CHECK(labelled.scores[i].score == falling[i]);
  CHECK(labelled.scores[0].query == 0);  // equal scores by query
  CHECK(labelled.scores[0].positive);
  CHECK_FALSE(labelled.scores[1].positive);
  CHECK(labelled.scores[2].positive);
  CHECK(labelled.totals[0].positives == 1);
  CHECK(labelled.totals[0].negatives == 1);
  CHECK(labelled.totals[3].positives == 0);
  CHECK(labelled.totals[3].negatives == 3);

  const LabelledScores best = single_best(labelled);
  REQUIRE(best.scores.size() == 4);
  CHECK(best.scores[0].positive);
  CHECK_FALSE(best.scores[1].positive);
  CHECK(best.totals[1].positives == 1);
  CHECK(best.totals[2].positives == 0);
}

TEST_CASE("a list of all pairs is labelled like the matrix", "[evaluation]") {
  std::mt19937 random(11);
  for (int i = 0; i < 500; ++i) {
    const auto problem = random_scored_places(random);
    std::vector<ScoredPair> pairs;
    for (Eigen::Index q = 0; q < problem.scores.rows(); ++q) {
      for (Eigen::Index c = 0; c < problem.scores.cols(); ++c) {
        pairs.push_back({std::uint32_t(q), std::uint32_t(c), problem.scores(q, c)});
      }
    }
    std::shuffle(pairs.begin(), pairs.end(), random);
    const LabelledScores a = problem.labelled();
    const LabelledScores b = label_scores(pairs, problem.truth());
    REQUIRE(a.scores.size() == b.scores.size());
    for (std::size_t k = 0; k < a.scores.size(); ++k) {
      CHECK(a.scores[k].score == b.scores[k].score);
      CHECK(a.scores[k].query == b.scores[k].query);
      CHECK(a.scores[k].positive == b.scores[k].positive);
    }
  }
}

TEST_CASE("pairs without a score count in the totals", "[evaluation]") {
  const LabelledScores labelled =
      label_scores(std::vector<ScoredPair>{{3, 0, 0.5}, {1, 0, 0.7}, {2, 2, 1.0}}, four_places());
  REQUIRE(labelled.scores.size() == 2);
  CHECK(labelled.scores[0].query == 1);
  CHECK(labelled.totals[0].positives == 1);
  CHECK(labelled.totals[3].negatives == 3);
}

TEST_CASE("scores that do not fit the truth are refused with their index", "[evaluation]") {
  const auto index_of_refusal = [](std::vector<ScoredPair> pairs) {
    try {
      label_scores(pairs, four_places());
    } catch (const Error& error) {
      return error.index().value_or(99);
    }
    return std::size_t{1000};
  };
  CHECK(index_of_refusal({{0, 1, 0.5}, {0, 4, 0.5}}) == 1);
  CHECK(index_of_refusal({{4, 1, 0.5}}) == 0);
  CHECK(index_of_refusal({{0, 1, 0.5}, {0, 3, nothing}}) == 1);
  CHECK(index_of_refusal({{0, 1, 0.5}, {1, 0, 0.5}, {0, 1, 0.4}}) == 99);
  CHECK_THROWS_AS(label_scores(ScoreMatrix::Zero(4, 3), four_places()), InvalidValue);
  ScoreMatrix scores = ScoreMatrix::Zero(4, 4);
  scores(0, 3) = -std::numeric_limits<double>::infinity();
  CHECK_THROWS_AS(label_scores(scores, four_places()), InvalidValue);
}
