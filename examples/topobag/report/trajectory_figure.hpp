// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "figure.hpp"
#include "query_outcome.hpp"

namespace program {

/// Both trajectories from above, with what became of every query: each answer joined to its place
/// in the map, and the queries that were missed. One trajectory is drawn once.
/// @param outcomes  per query
Figure trajectory_figure(const KnownPlaces& places, const std::vector<QueryOutcome>& outcomes,
                         bool one_trajectory);

}  // namespace program
