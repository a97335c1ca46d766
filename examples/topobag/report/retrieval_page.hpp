// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <topobag/evaluation/score_csv.hpp>

#include "html_page.hpp"
#include "query_outcome.hpp"
#include "score_figures.hpp"

namespace program {

/// A matrix of all scores, or a list of some; higher = more alike.
using PairScores = std::variant<topobag::ScoreMatrix, topobag::ScoreList>;

/// What `evaluate` reports on.
struct RetrievalRun {
  std::vector<NamedScores> methods;  ///< the method, and another one that it is held against
  PairScores scores;                 ///< of the method
  bool one_trajectory = true;
  std::optional<double> accept{};  ///< score from which on a query's best answer is accepted; none:
                                   ///< where F1 is best
  topobag::PoseLimits limits{};    ///< of the poses in a list
};

/// The figures of a method's scores.
Report retrieval_report(const KnownPlaces& places, const RetrievalRun& run);

}  // namespace program
