// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <topobag/evaluation/bootstrap.hpp>
#include <topobag/evaluation/labelled_scores.hpp>
#include <topobag/evaluation/loop_verdicts.hpp>

#include "json_output.hpp"

namespace program {

struct RetrievalReportOptions {
  std::vector<std::size_t> ks{1, 5, 10, 20};    ///< of Recall@K
  topobag::ResamplingOptions resampling{0, 1};  ///< of the confidence intervals
  double level = 0.95;                          ///< of the confidence intervals
  double score_sign = 1.0;                      ///< -1: thresholds are written negated
};

/// Counts, the metrics over all pairs and over each query's best, and Recall@K.
Json retrieval_json(const topobag::LabelledScores& labelled, const RetrievalReportOptions& options);

/// Whether `b` differs from `a` on the same queries: AP by a paired bootstrap, Recall@1 over the
/// queries with a positive by a paired randomization test. 1000 resamples when none are asked for.
Json comparison_json(const topobag::LabelledScores& a, const topobag::LabelledScores& b,
                     const RetrievalReportOptions& options);

Json verdicts_json(const topobag::LoopVerdicts& verdicts, const topobag::PoseLimits& limits);

/// The precision–recall curve over all pairs, a row per distinct score.
std::string curve_csv(const topobag::LabelledScores& labelled,
                      const RetrievalReportOptions& options);

/// A row per query: its evaluated pairs and the rank of its first positive, empty without one.
std::string ranks_csv(const topobag::LabelledScores& labelled);

}  // namespace program
