// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <topobag/evaluation/labelled_scores.hpp>

#include "figure.hpp"

namespace program {

/// Scores under the name that a figure gives them.
struct NamedScores {
  std::string name;
  topobag::LabelledScores labelled;
  double sign = 1.0;             ///< -1: lower was better, and scores are shown negated
  std::string scored = "pairs";  ///< what has the scores
};

/// A precision–recall curve for each method; those after the third look alike.
/// @param reading  what is ranked, and what is true
Figure precision_recall_figure(const std::vector<NamedScores>& methods, const std::string& reading);

/// Recall@K over K for each method, likewise.
Figure recall_at_k_figure(const std::vector<NamedScores>& methods);

/// How the scores of true and of false pairs are spread, each kind as shares of its own.
Figure score_histogram_figure(const std::string& id, const NamedScores& scores);

}  // namespace program
