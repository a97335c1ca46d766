// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include <topobag/bag/query.hpp>
#include <topobag/matching/match_options.hpp>
#include <topobag/recognition/decision_options.hpp>
#include <topobag/recognition/place_options.hpp>

namespace topobag {
inline namespace v0 {

/// The steps from a query to an answer.
struct RecognitionOptions {
  std::size_t max_candidates = 256;  ///< best of the retrieval that are matched; all in a small bag
  QueryOptions retrieval{};          ///< its `max_results` is overruled by `max_candidates`
  MatchOptions matching{};           ///< how poses are found
  PlaceOptions place{};              ///< how they are judged again by all that is around
  DecisionOptions decision{};        ///< when a pose is believed
};

}  // namespace v0
}  // namespace topobag
