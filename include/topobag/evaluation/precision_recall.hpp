// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <topobag/assert.hpp>
#include <topobag/evaluation/labelled_scores.hpp>

namespace topobag {
inline namespace v0 {

/// What accepting every score >= `threshold` gives.
struct OperatingPoint {
  double threshold = 0.0;           ///< scores from here on are accepted
  std::size_t true_positives = 0;   ///< true pairs accepted
  std::size_t false_positives = 0;  ///< false pairs accepted
  std::size_t positives = 0;        ///< ground truth: accepted or not

  /// True ones among the accepted; NaN when none is accepted.
  double precision() const noexcept {
    return static_cast<double>(true_positives) /
           static_cast<double>(true_positives + false_positives);
  }
  /// Accepted ones among the true; NaN when there is none.
  double recall() const noexcept {
    return static_cast<double>(true_positives) / static_cast<double>(positives);
  }
  /// 2PR / (P + R)
  double f1() const noexcept {
    return 2.0 * static_cast<double>(true_positives) /
           static_cast<double>(true_positives + false_positives + positives);
  }
};

/// How often each query counts; empty = every query once. Bootstrap resamples set it.
using QueryMultiplicity = std::vector<std::uint32_t>;

/// The sum of the queries' totals.
inline PairTotals sum_of_totals(const LabelledScores& labelled,
                                const QueryMultiplicity& multiplicity = {}) {
  TOPOBAG_ASSERT(multiplicity.empty() || multiplicity.size() == labelled.totals.size());
  PairTotals sum;
  for (std::size_t i = 0; i < labelled.totals.size(); ++i) {
    const std::size_t times = multiplicity.empty() ? 1 : multiplicity[i];
    sum.positives += times * labelled.totals[i].positives;
    sum.negatives += times * labelled.totals[i].negatives;
  }
  return sum;
}

/// Calls `visit(OperatingPoint)` for every distinct score, falling, ties together. O(n).
template <typename Visit>
void for_each_operating_point(const LabelledScores& labelled, const QueryMultiplicity& multiplicity,
                              Visit&& visit) {
  OperatingPoint point;
  point.positives = sum_of_totals(labelled, multiplicity).positives;
  const std::vector<LabelledScore>& scores = labelled.scores;
  for (std::size_t i = 0; i < scores.size(); ++i) {
    const std::size_t times = multiplicity.empty() ? 1 : multiplicity[scores[i].query];
    (scores[i].positive ? point.true_positives : point.false_positives) += times;
    if (i + 1 < scores.size() && scores[i + 1].score == scores[i].score) continue;
    if (point.true_positives + point.false_positives == 0) continue;  // no query of it drawn yet
    point.threshold = scores[i].score;
    visit(point);
  }
}

/// The precision–recall curve: a point per distinct score, falling; empty without a positive pair.
inline std::vector<OperatingPoint> precision_recall_curve(const LabelledScores& labelled) {
  std::vector<OperatingPoint> curve;
  if (sum_of_totals(labelled).positives == 0) return curve;
  for_each_operating_point(labelled, {}, [&](const OperatingPoint& p) { curve.push_back(p); });
  return curve;
}

/// The field's numbers for one precision–recall curve, over every distinct score.
struct RetrievalMetrics {
  double average_precision = 0.0;   ///< AP = Σ (R_n − R_{n−1}) P_n, no interpolation
  double auc_pr = 0.0;              ///< trapezoids over (R, P), from the point R = 0, P = 1
  double recall_at_100p = 0.0;      ///< R@100P: the largest R with P = 1, else 0
  double lowest_recall_p = 0.0;     ///< PR₀: P at the lowest R > 0; 0 if nothing true is found
  double extended_precision = 0.0;  ///< EP = (PR₀ + R@100P) / 2
  double f1_max = 0.0;              ///< F1max = max 2PR / (P + R)
  double f1_max_threshold = 0.0;    ///< the highest threshold that reaches it
  std::optional<double> precision_at_100r;  ///< P@100R; undefined when no threshold has R = 1
  /// Chance that a positive pair outscores a negative one, ties by half; pairs without a score tie
  /// below all others. Undefined without a total of negatives.
  std::optional<double> roc_auc;
};

/// The metrics; nothing without a positive pair. O(n).
inline std::optional<RetrievalMetrics> retrieval_metrics(
    const LabelledScores& labelled, const QueryMultiplicity& multiplicity = {}) {
  const PairTotals totals = sum_of_totals(labelled, multiplicity);
  if (totals.positives == 0) return std::nullopt;
  RetrievalMetrics metrics;
  double last_precision = 1.0;
  OperatingPoint last;
  last.positives = totals.positives;
  double roc_area = 0.0;
  const auto add_roc = [&](std::size_t true_positives, std::size_t false_positives) {
    roc_area += static_cast<double>(false_positives - last.false_positives) *
                static_cast<double>(true_positives + last.true_positives) / 2.0;
  };
  for_each_operating_point(labelled, multiplicity, [&](const OperatingPoint& point) {
    const double precision = point.precision();
    const double step = point.recall() - last.recall();
    metrics.average_precision += step * precision;
    metrics.auc_pr += step * (precision + last_precision) / 2.0;
    if (point.false_positives == 0) metrics.recall_at_100p = point.recall();
    if (last.true_positives == 0 && point.true_positives > 0) metrics.lowest_recall_p = precision;
    if (point.f1() > metrics.f1_max) {
      metrics.f1_max = point.f1();
      metrics.f1_max_threshold = point.threshold;
    }
    if (point.true_positives == point.positives && !metrics.precision_at_100r) {
      metrics.precision_at_100r = precision;
    }
    add_roc(point.true_positives, point.false_positives);
    last = point;
    last_precision = precision;
  });
  metrics.extended_precision = (metrics.lowest_recall_p + metrics.recall_at_100p) / 2.0;
  if (totals.negatives > 0) {
    add_roc(totals.positives, totals.negatives);
    metrics.roc_auc =
        roc_area / static_cast<double>(totals.positives) / static_cast<double>(totals.negatives);
  }
  return metrics;
}

}  // namespace v0
}  // namespace topobag
