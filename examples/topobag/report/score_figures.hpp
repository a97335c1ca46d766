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
  double sign = 1.0;  ///< -1: lower was better, and scores are shown negated
};

/// A precision–recall curve for each of up to three methods.
Figure precision_recall_figure(const std::vector<NamedScores>& methods);

/// Recall@K over K for each of up to three methods.
Figure recall_at_k_figure(const std::vector<NamedScores>& methods);

/// How the scores of true and of false pairs are spread, each kind as shares of its own.
Figure score_histogram_figure(const std::string& id, const NamedScores& scores);

}  // namespace program
