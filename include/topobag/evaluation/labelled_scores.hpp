// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <Eigen/Core>

#include <topobag/error.hpp>
#include <topobag/evaluation/place_truth.hpp>

namespace topobag {
inline namespace v0 {

/// Scores of every pair: a row per query, a column per candidate, higher = more alike.
using ScoreMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// One score of a method that does not score every pair.
struct ScoredPair {
  std::uint32_t query = 0;      ///< row of the score matrix
  std::uint32_t candidate = 0;  ///< column of the score matrix
  double score = 0.0;           ///< higher = more alike
};

/// A score with what the protocol says of its pair.
struct LabelledScore {
  double score = 0.0;       ///< higher = more alike
  std::uint32_t query = 0;  ///< row of the score matrix
  bool positive = false;    ///< what the protocol says of the pair
};

/// How many evaluated pairs a query has, scored or not.
struct PairTotals {
  std::size_t positives = 0;  ///< true pairs
  std::size_t negatives = 0;  ///< false pairs
};

/// What a protocol makes of a method's scores: all that the retrieval metrics need.
struct LabelledScores {
  std::vector<LabelledScore> scores;  ///< of positive and negative pairs: falling, then by query,
                                      ///< then by candidate
  std::vector<PairTotals> totals;     ///< per query; their sum is the metrics' ground truth
};

namespace detail {

inline void require_finite_score(double score, std::size_t query, std::size_t candidate,
                                 std::size_t index) {
  if (std::isfinite(score)) return;
  throw InvalidValue("the score of query " + std::to_string(query) + " and candidate " +
                         std::to_string(candidate) +
                         " is not finite; a pair without a score belongs in no list of scores",
                     index);
}

inline void add(PairTotals& totals, bool positive) {
  ++(positive ? totals.positives : totals.negatives);
}

/// Stable, so that equal scores keep the order of query and candidate.
template <typename Scores>
void sort_falling(Scores& scores) {
  std::stable_sort(scores.begin(), scores.end(),
                   [](const auto& a, const auto& b) { return a.score > b.score; });
}

}  // namespace detail

/// Labels a score for every pair. Excluded and ignored pairs are left out, whatever their score.
/// Throws InvalidValue when the matrix has another size than the truth or the score of an evaluated
/// pair is not finite. O(n log n) in the number of pairs.
/// @param truth  a `PlaceTruth`, or what else has `num_queries()`, `num_candidates()` and
///               `relation(query, candidate)`
template <typename Truth>
LabelledScores label_scores(const ScoreMatrix& scores, const Truth& truth) {
  const auto rows = static_cast<std::size_t>(scores.rows());
  const auto columns = static_cast<std::size_t>(scores.cols());
  if (rows != truth.num_queries() || columns != truth.num_candidates()) {
    throw InvalidValue("the scores are " + std::to_string(rows) + " × " + std::to_string(columns) +
                       ", but the poses make " + std::to_string(truth.num_queries()) +
                       " queries × " + std::to_string(truth.num_candidates()) + " candidates");
  }
  LabelledScores labelled;
  labelled.totals.resize(rows);
  labelled.scores.reserve(rows * columns);
  for (std::size_t query = 0; query < rows; ++query) {
    for (std::size_t candidate = 0; candidate < columns; ++candidate) {
      const PairRelation relation = truth.relation(query, candidate);
      if (relation == PairRelation::ignored || relation == PairRelation::excluded) continue;
      const bool positive = relation == PairRelation::positive;
      const std::size_t index = query * columns + candidate;
      const double score = scores.data()[index];
      detail::require_finite_score(score, query, candidate, index);
      detail::add(labelled.totals[query], positive);
      labelled.scores.push_back({score, static_cast<std::uint32_t>(query), positive});
    }
  }
  detail::sort_falling(labelled.scores);
  return labelled;
}

/// Labels a list of scores. A pair that is not in the list was never retrieved: it counts below
/// every score. Excluded and ignored pairs of the list are left out. Throws, with the index in the
/// list, InvalidId for a pair outside the truth and InvalidValue for a score that is not finite,
/// and InvalidId for a pair that is there twice. O(queries · candidates + n log n).
/// @param truth  as above
template <typename Truth>
LabelledScores label_scores(std::vector<ScoredPair> pairs, const Truth& truth) {
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (pairs[i].query >= truth.num_queries() || pairs[i].candidate >= truth.num_candidates()) {
      throw InvalidId("query " + std::to_string(pairs[i].query) + " or candidate " +
                          std::to_string(pairs[i].candidate) +
                          " has no pose: they are row numbers of the poses, " +
                          std::to_string(truth.num_queries()) + " queries and " +
                          std::to_string(truth.num_candidates()) + " candidates, from 0",
                      i);
    }
    detail::require_finite_score(pairs[i].score, pairs[i].query, pairs[i].candidate, i);
  }
  const auto same = [](const ScoredPair& a, const ScoredPair& b) {
    return a.query == b.query && a.candidate == b.candidate;
  };
  std::sort(pairs.begin(), pairs.end(), [](const ScoredPair& a, const ScoredPair& b) {
    return a.query != b.query ? a.query < b.query : a.candidate < b.candidate;
  });
  if (const auto twice = std::adjacent_find(pairs.begin(), pairs.end(), same);
      twice != pairs.end()) {
    throw InvalidId("query " + std::to_string(twice->query) + " and candidate " +
                    std::to_string(twice->candidate) + " have two scores");
  }
  LabelledScores labelled;
  labelled.totals.resize(truth.num_queries());
  auto next = pairs.begin();
  for (std::size_t query = 0; query < truth.num_queries(); ++query) {
    for (std::size_t candidate = 0; candidate < truth.num_candidates(); ++candidate) {
      const PairRelation relation = truth.relation(query, candidate);
      const bool scored =
          next != pairs.end() && next->query == query && next->candidate == candidate;
      const double score = scored ? (next++)->score : 0.0;
      if (relation == PairRelation::ignored || relation == PairRelation::excluded) continue;
      const bool positive = relation == PairRelation::positive;
      detail::add(labelled.totals[query], positive);
      if (scored) labelled.scores.push_back({score, static_cast<std::uint32_t>(query), positive});
    }
  }
  detail::sort_falling(labelled.scores);
  return labelled;
}

/// Keeps each query's best score (ties: the first candidate). A positive total is then the number
/// of queries with at least one positive; negatives have no total, so the ROC is undefined.
inline LabelledScores single_best(const LabelledScores& labelled) {
  LabelledScores best;
  for (const PairTotals& totals : labelled.totals) {
    best.totals.push_back({totals.positives > 0 ? std::size_t{1} : std::size_t{0}, 0});
  }
  std::vector<bool> taken(labelled.totals.size(), false);
  for (const LabelledScore& score : labelled.scores) {
    if (taken[score.query]) continue;
    taken[score.query] = true;
    best.scores.push_back(score);
  }
  return best;
}

}  // namespace v0
}  // namespace topobag
