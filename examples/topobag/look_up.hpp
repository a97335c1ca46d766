// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <topobag/bag/query.hpp>

#include "recognition_run.hpp"

// The program's one place that matches graphs, which is slow to compile. Each call replaces the
// run's look-ups; the ids in them are positions in the run's map.
namespace program {

/// Looks every query up in the whole map, by the library's defaults.
void look_up_in_map(RecognitionRun& run);

/// Looks every key frame of a sequence up among those at least `min_gap` s older. Precondition: map
/// and queries are the same.
void look_up_earlier(RecognitionRun& run, double min_gap);

/// Verifies each query's own candidates, by the library's defaults, whoever retrieved them.
/// @param candidates  parallel to the run's queries
void verify(RecognitionRun& run, const std::vector<std::vector<topobag::Candidate>>& candidates);

}  // namespace program
