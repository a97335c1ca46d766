// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "html_page.hpp"
#include "pair_scores.hpp"
#include "query_outcome.hpp"
#include "score_figures.hpp"

namespace program {

/// What `evaluate` and `compare` report on.
struct RetrievalRun {
  std::vector<NamedScores> methods;  ///< the method, and others that it is held against
  PairScores scores;                 ///< of the method
  bool one_trajectory = true;
  std::optional<double> accept{};  ///< score from which on a query's best answer is accepted; none:
                                   ///< where F1 is best
  topobag::PoseLimits limits{};    ///< of the poses in a list
  std::vector<QueryOutcome> outcomes{};  ///< of the queries, where a decision made them; else by
                                         ///< `accept`
};

/// The figures of a method's scores.
Report retrieval_report(const KnownPlaces& places, const RetrievalRun& run);

}  // namespace program
