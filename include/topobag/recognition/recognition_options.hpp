// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include <topobag/bag/query.hpp>
#include <topobag/matching/class_groups.hpp>
#include <topobag/matching/match_options.hpp>
#include <topobag/matching/usual_size_spreads.hpp>
#include <topobag/recognition/decision_options.hpp>
#include <topobag/recognition/place_options.hpp>
#include <topobag/types/class_catalog.hpp>

namespace topobag {
inline namespace v0 {

/// The steps from a query to an answer.
struct RecognitionOptions {
  std::size_t max_candidates = 64;  ///< best of the retrieval that are matched; all in a small bag
  QueryOptions retrieval{};         ///< its `max_results` is overruled by `max_candidates`
  MatchOptions matching{};          ///< how poses are found
  PlaceOptions place{};             ///< how they are judged again by all that is around
  DecisionOptions decision{};       ///< when a pose is believed
};

/// The defaults for nodes with the labels of a catalog: classes of it that detectors mix up on
/// nearly every desk may be one object (`lookalike_classes`), and sizes of a class differ as they
/// usually do (`usual_size_spreads`).
///
///     Relocalizer<> relocalizer(recognition_options(ClassCatalog::coco80()));
inline RecognitionOptions recognition_options(const ClassCatalog& catalog) {
  RecognitionOptions options;
  options.matching.consistency.classes = lookalike_classes(catalog);
  options.matching.chance.sizes.classes = usual_size_spreads(catalog);
  return options;
}

}  // namespace v0
}  // namespace topobag
