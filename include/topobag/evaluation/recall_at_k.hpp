// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <topobag/assert.hpp>
#include <topobag/evaluation/labelled_scores.hpp>

namespace topobag {
inline namespace v0 {

/// The rank, from 1, of each query's first positive among its own evaluated candidates, ties in the
/// candidates' order; 0 for a query without a scored positive. O(n).
inline std::vector<std::size_t> first_positive_ranks(const LabelledScores& labelled) {
  std::vector<std::size_t> ranks(labelled.totals.size(), 0);
  std::vector<std::size_t> seen(labelled.totals.size(), 0);
  for (const LabelledScore& score : labelled.scores) {
    ++seen[score.query];
    if (score.positive && ranks[score.query] == 0) ranks[score.query] = seen[score.query];
  }
  return ranks;
}

/// Recall at K under both denominators in use; undefined where there is no such query.
struct RecallAtK {
  std::size_t hits = 0;                   ///< queries whose top K contain a positive
  std::size_t queries_with_positive = 0;  ///< that have a true candidate
  std::size_t queries = 0;                ///< all of them

  /// Over the queries that have a true candidate.
  std::optional<double> of_queries_with_positive() const { return ratio(queries_with_positive); }
  /// Over all queries.
  std::optional<double> of_all_queries() const { return ratio(queries); }

 private:
  std::optional<double> ratio(std::size_t denominator) const {
    if (denominator == 0) return std::nullopt;
    return static_cast<double>(hits) / static_cast<double>(denominator);
  }
};

/// Recall at K, K >= 1. O(n).
inline RecallAtK recall_at_k(const LabelledScores& labelled, std::size_t k) {
  TOPOBAG_ASSERT(k >= 1);
  RecallAtK recall;
  recall.queries = labelled.totals.size();
  for (const PairTotals& totals : labelled.totals) {
    if (totals.positives > 0) ++recall.queries_with_positive;
  }
  for (const std::size_t rank : first_positive_ranks(labelled)) {
    if (rank >= 1 && rank <= k) ++recall.hits;
  }
  return recall;
}

}  // namespace v0
}  // namespace topobag
