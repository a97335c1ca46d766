// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include <topobag/bag/query.hpp>
#include <topobag/matching/appearance_model.hpp>
#include <topobag/matching/class_groups.hpp>
#include <topobag/matching/match_options.hpp>
#include <topobag/matching/usual_size_spreads.hpp>
#include <topobag/recognition/decision_options.hpp>
#include <topobag/recognition/place_options.hpp>
#include <topobag/sensing/sensor_profile.hpp>
#include <topobag/types/class_catalog.hpp>

namespace topobag {
inline namespace v0 {

/// The steps from a query to an answer.
struct RecognitionOptions {
  QueryOptions retrieval{64};  ///< whom to match: its best so many, all in a small bag
  MatchOptions matching{};     ///< how poses are found
  PlaceOptions place{};        ///< how they are judged again by all that is around
  DecisionOptions decision{};  ///< when a pose is believed
};

/// What looks are judged by: what the decision's calibration learnt of them, where it did, for its
/// scores were made with that; else the matching's own.
inline const AppearanceModel& appearance_model(const RecognitionOptions& options) noexcept {
  const auto& calibration = options.decision.calibration;
  return calibration && calibration->appearance() ? *calibration->appearance()
                                                  : options.matching.chance.appearance;
}

/// The defaults for a sensor.
inline RecognitionOptions recognition_options(const SensorProfile& sensor) {
  RecognitionOptions options;
  MatchOptions& matching = options.matching;
  matching.consistency.min_tolerance = sensor.least_tolerance;
  matching.consistency.max_tolerance = sensor.gate;
  matching.consistency.noise = sensor.noise;
  matching.inlier_deviations = sensor.gate_deviations;
  matching.max_residual = sensor.gate;
  matching.min_spread = sensor.min_spread;
  matching.distinct_translation = sensor.pose_resolution;
  matching.missing.max_depth = sensor.sure_range;
  PlaceOptions& place = options.place;
  place.distinct_translation = sensor.place_resolution;
  place.radius = sensor.place_radius;
  place.margin = sensor.place_margin;
  place.max_depth = sensor.detection_range;
  place.fusing = local_graph_options(sensor);
  return options;
}

/// The defaults for nodes with the labels of a catalog: classes of it that detectors mix up on
/// nearly every desk may be one object (`lookalike_classes`), and sizes of a class differ as they
/// usually do (`usual_size_spreads`).
///
///     Relocalizer<> relocalizer(recognition_options(ClassCatalog::coco80()));
inline RecognitionOptions recognition_options(const ClassCatalog& catalog,
                                              const SensorProfile& sensor = {}) {
  RecognitionOptions options = recognition_options(sensor);
  options.matching.consistency.classes = lookalike_classes(catalog);
  options.matching.chance.sizes.classes = usual_size_spreads(catalog);
  return options;
}

}  // namespace v0
}  // namespace topobag
