// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <topobag/evaluation/labelled_scores.hpp>

#include "comparison.hpp"
#include "html_page.hpp"
#include "query_outcome.hpp"

namespace program {

/// What a comparison's first method, the library at its defaults, decided.
struct DecidedScores {
  topobag::ScoreMatrix scores;         ///< by which it ranks places
  std::vector<QueryOutcome> outcomes;  ///< by the verdicts on its poses
  topobag::PoseLimits limits;          ///< of those
  bool one_sequence = false;
};

/// The table of a comparison, the curves of all methods, and the figures of what was decided.
Report comparison_report(const Comparison& comparison, const KnownPlaces& places,
                         DecidedScores decided);

}  // namespace program
