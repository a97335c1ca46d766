// SPDX-License-Identifier: MIT
#include <set>

#include <topobag/evaluation/precision_recall.hpp>

#include "catch.hpp"
#include "evaluation/random_scores.hpp"

using namespace topobag;

namespace {

/// One query's scores, falling, with the labels given.
LabelledScores one_query(const std::vector<std::pair<double, bool>>& scores,
                         std::size_t more_positives = 0, std::size_t more_negatives = 0) {
  LabelledScores labelled;
  labelled.totals = {{more_positives, more_negatives}};
  for (const auto& [score, positive] : scores) {
    labelled.scores.push_back({score, 0, positive});
    ++(positive ? labelled.totals[0].positives : labelled.totals[0].negatives);
  }
  return labelled;
}

struct Item {
  double score;
  bool positive;
};

/// The definitions of the metrics, threshold by threshold and pair by pair, from a bag of items.
RetrievalMetrics by_definition(const std::vector<Item>& items) {
  std::set<double, std::greater<>> thresholds;
  double positives = 0.0;
  for (const Item& item : items) {
    thresholds.insert(item.score);
    positives += item.positive;
  }
  std::vector<double> P{1.0};
  std::vector<double> R{0.0};
  for (const double t : thresholds) {
    double accepted = 0.0;
    double right = 0.0;
    for (const Item& item : items) {
      accepted += item.score >= t;
      right += item.score >= t && item.positive;
    }
    P.push_back(right / accepted);
    R.push_back(right / positives);
  }
  RetrievalMetrics m;
  double lowest = 2.0;
  for (std::size_t n = 1; n < P.size(); ++n) {
    m.average_precision += (R[n] - R[n - 1]) * P[n];
    m.auc_pr += (R[n] - R[n - 1]) * (P[n] + P[n - 1]) / 2.0;
    if (P[n] == 1.0) m.recall_at_100p = std::max(m.recall_at_100p, R[n]);
    if (P[n] + R[n] > 0.0) m.f1_max = std::max(m.f1_max, 2.0 * P[n] * R[n] / (P[n] + R[n]));
    if (R[n] > 0.0 && R[n] < lowest) {
      lowest = R[n];
      m.lowest_recall_p = P[n];
    }
    if (R[n] == 1.0) m.precision_at_100r = std::max(m.precision_at_100r.value_or(0.0), P[n]);
  }
  m.extended_precision =
      (m.lowest_recall_p + (m.lowest_recall_p < 1.0 ? 0.0 : m.recall_at_100p)) / 2.0;
  double wins = 0.0;
  double duels = 0.0;
  for (const Item& p : items) {
    for (const Item& n : items) {
      if (!p.positive || n.positive) continue;
      duels += 1.0;
      wins += p.score > n.score ? 1.0 : p.score == n.score ? 0.5 : 0.0;
    }
  }
  if (duels > 0.0) m.roc_auc = wins / duels;
  return m;
}

void check_equal(const RetrievalMetrics& a, const RetrievalMetrics& b) {
  const auto same = [](double x, double y) { CHECK(x == Approx(y).epsilon(0).margin(1e-12)); };
  same(a.average_precision, b.average_precision);
  same(a.auc_pr, b.auc_pr);
  same(a.recall_at_100p, b.recall_at_100p);
  same(a.lowest_recall_p, b.lowest_recall_p);
  same(a.extended_precision, b.extended_precision);
  same(a.f1_max, b.f1_max);
  same(a.precision_at_100r.value_or(-1.0), b.precision_at_100r.value_or(-1.0));
  same(a.roc_auc.value_or(-1.0), b.roc_auc.value_or(-1.0));
}

}  // namespace

TEST_CASE("scikit-learn's documented example", "[evaluation]") {
  // y_true = 0 0 1 1, y_score = 0.1 0.4 0.35 0.8: AP 0.83, ROC AUC 0.75.
  const auto m =
      retrieval_metrics(one_query({{0.8, true}, {0.4, false}, {0.35, true}, {0.1, false}}));
  REQUIRE(m);
  CHECK(m->average_precision == Approx(5.0 / 6.0));
  CHECK(m->auc_pr == Approx(0.5 + 0.5 * (1.0 / 2.0 + 2.0 / 3.0) / 2.0));
  CHECK(*m->roc_auc == 0.75);
  CHECK(m->recall_at_100p == 0.5);
  CHECK(m->extended_precision == 0.75);
  CHECK(m->f1_max == Approx(0.8));
  CHECK(m->f1_max_threshold == 0.35);
  CHECK(*m->precision_at_100r == Approx(2.0 / 3.0));
}

TEST_CASE("the first answer wrong: R@100P and with it EP's second half are 0", "[evaluation]") {
  const auto m = retrieval_metrics(one_query({{3, false}, {2, true}, {1, true}}));
  CHECK(m->recall_at_100p == 0.0);
  CHECK(m->lowest_recall_p == 0.5);
  CHECK(m->extended_precision == 0.25);
  CHECK(m->average_precision == Approx(0.5 * 0.5 + 0.5 * 2.0 / 3.0));
}

TEST_CASE("equal scores are accepted together", "[evaluation]") {
  const auto m = retrieval_metrics(one_query({{1, true}, {1, false}, {1, true}, {1, false}}));
  CHECK(m->average_precision == 0.5);
  CHECK(m->recall_at_100p == 0.0);
  CHECK(*m->roc_auc == 0.5);
  CHECK(precision_recall_curve(one_query({{1, true}, {1, false}})).size() == 1);
}

TEST_CASE("positives that nobody scored are missed", "[evaluation]") {
  const auto m = retrieval_metrics(one_query({{2, true}, {1, true}}, 2, 5));
  CHECK(m->average_precision == 0.5);
  CHECK(m->recall_at_100p == 0.5);
  CHECK(m->f1_max == Approx(2.0 / 3.0));
  CHECK_FALSE(m->precision_at_100r);
  CHECK(*m->roc_auc == 0.75);  // two of four win, two tie with the five at the bottom
  CHECK_FALSE(retrieval_metrics(one_query({{2, false}}, 0, 5)));
  CHECK(precision_recall_curve(one_query({{2, false}})).empty());
  const auto none = retrieval_metrics(one_query({}, 3, 0));
  CHECK(none->average_precision == 0.0);
  CHECK(none->lowest_recall_p == 0.0);
  CHECK_FALSE(none->roc_auc);
}

TEST_CASE("the metrics equal their definitions on 10,000 problems with ties", "[evaluation]") {
  std::mt19937 random(12);
  int compared = 0;
  while (compared < 10000) {
    const auto problem = topobag_tests::random_scored_places(random);
    const PlaceTruth truth = problem.truth();
    std::vector<Item> items;
    std::vector<Item> best;
    bool any_positive = false;
    for (std::size_t q = 0; q < truth.num_queries(); ++q) {
      Item top{-1.0, false};
      bool has_positive = false;
      for (std::size_t c = 0; c < truth.num_candidates(); ++c) {
        const PairRelation relation = truth.relation(q, c);
        if (relation != PairRelation::positive && relation != PairRelation::negative) continue;
        items.push_back(
            {problem.scores(Eigen::Index(q), Eigen::Index(c)), relation == PairRelation::positive});
        has_positive = has_positive || items.back().positive;
        if (items.back().score > top.score) top = items.back();
      }
      any_positive = any_positive || has_positive;
      // A query with a positive but another best answer is a positive that is never found.
      if (top.score > 0.0) best.push_back(top);
      if (has_positive && !top.positive) best.push_back({-2.0, true});
    }
    const LabelledScores labelled = problem.labelled();
    const auto metrics = retrieval_metrics(labelled);
    REQUIRE(metrics.has_value() == any_positive);
    if (!any_positive) continue;
    ++compared;
    check_equal(*metrics, by_definition(items));

    // Single best: the missed positives sit at a last threshold that is no real one.
    const auto single = retrieval_metrics(single_best(labelled));
    RetrievalMetrics expected = by_definition(best);
    if (best.size() != single_best(labelled).scores.size()) {
      double positives = 0.0;
      double found = 0.0;
      for (const Item& item : best) positives += item.positive;
      for (const Item& item : best) found += item.positive && item.score > 0.0;
      const double rest = 1.0 - found / positives;
      const double last = positives / double(best.size());
      const double before = found / double(single_best(labelled).scores.size());
      expected.average_precision -= rest * last;
      expected.auc_pr -= rest * (last + before) / 2.0;
      CHECK(single->average_precision == Approx(expected.average_precision).margin(1e-12));
      CHECK(single->auc_pr == Approx(expected.auc_pr).margin(1e-12));
      CHECK_FALSE(single->precision_at_100r);
    } else {
      expected.roc_auc.reset();
      check_equal(*single, expected);
    }
    CHECK_FALSE(single->roc_auc);
  }
}

TEST_CASE("drawing a query twice is having its pairs twice", "[evaluation]") {
  std::mt19937 random(13);
  for (int i = 0; i < 1000; ++i) {
    const LabelledScores labelled = topobag_tests::random_scored_places(random).labelled();
    QueryMultiplicity times(labelled.totals.size());
    for (auto& n : times) n = std::uniform_int_distribution<std::uint32_t>(0, 2)(random);
    LabelledScores copied;
    copied.totals.resize(labelled.totals.size());
    for (std::size_t q = 0; q < times.size(); ++q) {
      copied.totals[q].positives = times[q] * labelled.totals[q].positives;
      copied.totals[q].negatives = times[q] * labelled.totals[q].negatives;
    }
    for (const LabelledScore& score : labelled.scores) {
      copied.scores.insert(copied.scores.end(), times[score.query], score);
    }
    const auto a = retrieval_metrics(labelled, times);
    const auto b = retrieval_metrics(copied);
    REQUIRE(a.has_value() == b.has_value());
    if (a) check_equal(*a, *b);
  }
}

TEST_CASE("the curve's points are the operating points", "[evaluation]") {
  const auto curve =
      precision_recall_curve(one_query({{3, true}, {2, false}, {2, true}, {1, false}}));
  REQUIRE(curve.size() == 3);
  CHECK(curve[1].threshold == 2.0);
  CHECK(curve[1].precision() == Approx(2.0 / 3.0));
  CHECK(curve[1].recall() == 1.0);
  CHECK(curve[1].f1() == Approx(0.8));
  CHECK(curve[2].precision() == 0.5);
}
