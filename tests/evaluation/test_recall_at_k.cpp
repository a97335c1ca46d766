// SPDX-License-Identifier: MIT
#include <topobag/evaluation/recall_at_k.hpp>

#include "catch.hpp"
#include "evaluation/random_scores.hpp"

using namespace topobag;

TEST_CASE("Recall@K names its denominator", "[evaluation]") {
  LabelledScores labelled;
  labelled.totals = {{1, 2}, {2, 0}, {0, 3}, {1, 1}};
  labelled.scores = {{0.9, 0, false}, {0.8, 1, true}, {0.7, 2, false}, {0.6, 0, true}};
  const RecallAtK at_1 = recall_at_k(labelled, 1);
  CHECK(at_1.hits == 1);
  CHECK(*at_1.of_queries_with_positive() == Approx(1.0 / 3.0));
  CHECK(*at_1.of_all_queries() == 0.25);
  CHECK(*recall_at_k(labelled, 2).of_queries_with_positive() == Approx(2.0 / 3.0));
  CHECK(*recall_at_k(labelled, 20).of_all_queries() == 0.5);
  CHECK(first_positive_ranks(labelled) == std::vector<std::size_t>{2, 1, 0, 0});
  CHECK_FALSE(recall_at_k({}, 1).of_all_queries());
}

TEST_CASE("Recall@K equals its definition on 10,000 problems with ties", "[evaluation]") {
  std::mt19937 random(14);
  for (int round = 0; round < 10000; ++round) {
    const auto problem = topobag_tests::random_scored_places(random);
    const PlaceTruth truth = problem.truth();
    const std::size_t k = 1 + static_cast<std::size_t>(round % 5);
    std::size_t hits = 0;
    std::size_t with_positive = 0;
    for (std::size_t q = 0; q < truth.num_queries(); ++q) {
      bool any = false;
      bool hit = false;
      for (std::size_t c = 0; c < truth.num_candidates(); ++c) {
        if (truth.relation(q, c) != PairRelation::positive) continue;
        any = true;
        // A candidate is in the top K when fewer than K others come before it.
        std::size_t before = 0;
        for (std::size_t o = 0; o < truth.num_candidates(); ++o) {
          const PairRelation relation = truth.relation(q, o);
          if (relation != PairRelation::positive && relation != PairRelation::negative) continue;
          const double mine = problem.scores(Eigen::Index(q), Eigen::Index(c));
          const double other = problem.scores(Eigen::Index(q), Eigen::Index(o));
          before += other > mine || (other == mine && o < c);
        }
        hit = hit || before < k;
      }
      with_positive += any;
      hits += hit;
    }
    const RecallAtK recall = recall_at_k(problem.labelled(), k);
    CHECK(recall.hits == hits);
    CHECK(recall.queries_with_positive == with_positive);
    CHECK(recall.queries == truth.num_queries());
  }
}
