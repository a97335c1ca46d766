// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <topobag/evaluation/labelled_scores.hpp>

#include "query_outcome.hpp"
#include "recognition_run.hpp"

namespace program {

/// What became of each query of a scored run, by the verdicts on its poses.
/// @param places  null where the truth is not known
std::vector<QueryOutcome> outcomes_of(const RecognitionRun& run, const KnownPlaces* places);

/// Each query's answer by the score that decides: its best match, but for one that was refused for
/// another reason than its score. An answer is true when its pose is not wrong; to be found is what
/// has a true place or a true answer. Precondition: the true poses are known.
topobag::LabelledScores answer_scores(const RecognitionRun& run, const KnownPlaces& places,
                                      const Scoring& scoring);

}  // namespace program
