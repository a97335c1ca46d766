// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>

#include "recognition_run.hpp"

namespace program {

/// Draws the accepted match of the best score: the graphs of the map's and the query's key frame
/// side by side as their cameras see them, matched objects joined. Without an accepted match the
/// drawing says so. Throws InputError where a graph of the two holds no view.
std::string match_svg(const RecognitionRun& run);

/// Whether both graphs of the accepted match of one query hold a view. Precondition: it has one.
bool is_drawable(const RecognitionRun& run, std::size_t index);

/// The same of the accepted match of one query. On an HTML page, too: its styles are its own.
/// Precondition: the query has an accepted match. Throws as above.
std::string match_svg(const RecognitionRun& run, std::size_t index);

/// Draws any candidate of a query, accepted or not: the same, with its verdict, and frames about
/// the objects that were expected and are missing. Throws as above.
std::string candidate_svg(const RecognitionRun& run, std::size_t index,
                          const topobag::CandidateReport& candidate);

}  // namespace program
