// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <string>
#include <variant>

#include <topobag/evaluation/labelled_scores.hpp>
#include <topobag/evaluation/place_truth.hpp>
#include <topobag/evaluation/score_csv.hpp>

namespace program {

/// A matrix of all scores, or a list of some; higher = more alike.
using PairScores = std::variant<topobag::ScoreMatrix, topobag::ScoreList>;

/// Reads a matrix (.npy or CSV) or a list (CSV with a header), which is told by the content. Throws
/// topobag::Error, also where there is no score in it.
PairScores read_pair_scores(const std::string& path, bool lower_is_better);

/// The scores with what the truth says of them. Throws InputError, naming the file, where they do
/// not fit it.
topobag::LabelledScores label_scores(const PairScores& scores, const topobag::PlaceTruth& truth,
                                     const std::string& path);

/// How many of the pairs that the truth calls true or false have no score, as the end of a
/// sentence; empty where all have one.
std::string unscored_text(const topobag::LabelledScores& labelled, std::size_t pairs);

/// How many pairs the protocol says this of. O(queries · candidates).
std::size_t count_pairs(const topobag::PlaceTruth& truth, topobag::PairRelation relation);

/// Calls `visit(query, candidate, score)` for every score, by query, then by candidate.
template <typename Visit>
void for_each_score(const PairScores& scores, Visit&& visit) {
  if (const auto* const matrix = std::get_if<topobag::ScoreMatrix>(&scores)) {
    for (Eigen::Index i = 0; i < matrix->rows(); ++i) {
      for (Eigen::Index k = 0; k < matrix->cols(); ++k) {
        if (!std::isfinite((*matrix)(i, k))) continue;
        visit(static_cast<std::size_t>(i), static_cast<std::size_t>(k), (*matrix)(i, k));
      }
    }
    return;
  }
  for (const topobag::ScoredPair& pair : std::get<topobag::ScoreList>(scores).pairs) {
    visit(pair.query, pair.candidate, pair.score);
  }
}

}  // namespace program
