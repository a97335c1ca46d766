// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "figure.hpp"
#include "query_outcome.hpp"
#include "recognition_run.hpp"

namespace program {

// `places` is null where the truth is not known.

/// A row for every candidate that was tried.
DataTable pair_table(const RecognitionRun& run, const KnownPlaces* places);

/// Precision and recall of the queries' answers and how their scores are spread; how far down the
/// true places stand among all candidates, and how their similarities are spread.
std::vector<Figure> answer_figures(const RecognitionRun& run, const KnownPlaces& places,
                                   const Scoring& scoring);

/// The matrices of similarities and of match scores. The first has the numbers of the pairs, unless
/// they are too many for a page.
/// @param outcomes  per query
std::vector<Figure> matrix_figures(const RecognitionRun& run, const KnownPlaces* places,
                                   const std::vector<QueryOutcome>& outcomes);

/// How far the best candidates came.
Figure verdict_figure(const RecognitionRun& run);

}  // namespace program
