// SPDX-License-Identifier: MIT
#pragma once

#include <topobag/evaluation/labelled_scores.hpp>

#include "comparison.hpp"
#include "html_page.hpp"
#include "query_outcome.hpp"

namespace program {

/// The table of a comparison, and the figures of its first method's scores beside the curves of its
/// second and of the best of the others.
/// @param scores  the first method's
Report comparison_report(const Comparison& comparison, const KnownPlaces& places,
                         const topobag::ScoreMatrix& scores, bool one_sequence);

}  // namespace program
