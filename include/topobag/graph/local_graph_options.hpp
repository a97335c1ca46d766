// SPDX-License-Identifier: MIT
#pragma once

#include <topobag/sensing/same_object.hpp>
#include <topobag/sensing/sensor_profile.hpp>

namespace topobag {
inline namespace v0 {

/// Over how long nodes are fused, and which are one object.
struct LocalGraphOptions {
  double window = 3.0;  ///< s; views older than the newest by more are forgotten
  double gate =
      default_sensor.gate_deviations;  ///< σ within which a sighting joins an object of its class
  double other_class_gate = 1.0;  ///< σ for another class: detectors waver between tv and laptop
  SameObject merge{0.3};          ///< when two objects of whatever class are made one
  double merge_gate = 2.0;        ///< σ for two of one class that no view shows together
  double correlation = 0.5;    ///< share of a sighting's, or a gravity's, error that others repeat
  double image_margin = 20.0;  ///< px from the border within which nothing need show
  double max_depth = default_sensor.detection_range;  ///< m beyond which nothing need show
  double min_existence = 0.2;  ///< share of the views due to show an object that must have
};

/// The same for a sensor.
inline LocalGraphOptions local_graph_options(const SensorProfile& sensor) {
  LocalGraphOptions options;
  options.gate = sensor.gate_deviations;
  options.max_depth = sensor.detection_range;
  return options;
}

}  // namespace v0
}  // namespace topobag
