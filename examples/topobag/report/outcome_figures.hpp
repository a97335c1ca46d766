// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <topobag/evaluation/pose_error.hpp>

#include "figure.hpp"
#include "query_outcome.hpp"

namespace program {

/// What became of the queries that have a true place, by view angle, overlap, number of objects and
/// time gap, as far as these are known.
std::vector<Figure> breakdown_figures(const std::vector<QueryOutcome>& outcomes);

/// The error of an answer's pose and the verdict on it.
struct JudgedError {
  topobag::PoseError error;
  Outcome outcome = Outcome::correct;
};

/// Histograms of the translation errors and of the rotation errors.
std::vector<Figure> error_figures(const std::vector<JudgedError>& errors,
                                  const topobag::PoseLimits& limits);

}  // namespace program
