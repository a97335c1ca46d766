// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <set>
#include <string>
#include <vector>

#include "pooled_figures.hpp"

/// The queries of a run, and of which places they tell.
struct RunQueries {
  std::vector<std::string> places;
  std::vector<ScoredQuery> queries;
};

/// What comes of choosing the margin to ask for without the runs that tell of a place.
struct LeftOut {
  std::string place;
  double margin = 0.0;  ///< the least by which at most the allowed share of all other queries is
                        ///< answered falsely
  Figures kept;         ///< of those other queries
  Figures left_out;     ///< of the place's, which had no say
};

/// Leaves out each place in turn, in alphabetical order. O(places · n log n).
/// @param false_share  of the queries, that may be answered falsely
inline std::vector<LeftOut> leave_one_out(const std::vector<RunQueries>& runs, double false_share) {
  std::set<std::string> places;
  for (const RunQueries& run : runs) places.insert(run.places.begin(), run.places.end());
  std::vector<LeftOut> folds;
  for (const std::string& place : places) {
    std::vector<ScoredQuery> kept, left_out;
    for (const RunQueries& run : runs) {
      const bool tells = std::find(run.places.begin(), run.places.end(), place) != run.places.end();
      auto& pool = tells ? left_out : kept;
      pool.insert(pool.end(), run.queries.begin(), run.queries.end());
    }
    const auto allowed = static_cast<std::size_t>(false_share * static_cast<double>(kept.size()));
    const double margin = margin_for(kept, allowed);
    folds.push_back({place, margin, figures_at(kept, margin), figures_at(left_out, margin)});
  }
  return folds;
}
