// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include <topobag/matching/bearing_chance.hpp>
#include <topobag/sensing/sensor_profile.hpp>

namespace topobag {
inline namespace v0 {

/// How poses are found from bearings, beside what `MatchOptions` says of every match.
struct BearingOptions {
  BearingChance chance{};       ///< how often chance does as well
  double max_size_ratio = 2.0;  ///< between the range that a box's size tells and the pose's
  double min_range = default_sensor.min_depth;        ///< m within which objects are seen
  double max_range = default_sensor.detection_range;  ///< m
  double max_angle = 0.15;          ///< rad; a bearing further from an object supports no pose
  std::size_t max_triples = 4000;   ///< of pairs, the rarest classes first, whose poses are tried
  std::size_t max_hypotheses = 24;  ///< poses that are refined: most supporters first
  double max_translation_deviation = 0.3;  ///< m; a pose less certain is degenerate
  double surplus = 0.5;  ///< decades by which the chance of bearings is bounded too carefully, as
                         ///< measured, beyond those of `DecisionOptions`
};

}  // namespace v0
}  // namespace topobag
