// SPDX-License-Identifier: MIT
#pragma once

#include <topobag/sensing/node_noise.hpp>
#include <topobag/sensing/same_object.hpp>
#include <topobag/sensing/sensor_profile.hpp>
#include <topobag/types/dynamics.hpp>

namespace topobag {
inline namespace v0 {

/// Which detections become nodes.
struct LiftOptions {
  DynamicsSet keep{Dynamics::low,
                   Dynamics::medium};           ///< dynamic filter (3.1): levels that are kept
  double min_confidence = 0.3;                  ///< detector's score
  double min_depth = default_sensor.min_depth;  ///< m
  double max_depth = default_sensor.max_depth;  ///< m
  double max_image_share = 0.5;  ///< share of the image's area; such a box is a room, not an object
  SameObject duplicate{};        ///< of two nodes that are one object the surer one is kept
  NodeNoise noise{};             ///< gives each node its covariance
};

/// The same for a sensor.
inline LiftOptions lift_options(const SensorProfile& sensor) {
  LiftOptions options;
  options.min_depth = sensor.min_depth;
  options.max_depth = sensor.max_depth;
  options.noise = sensor.noise;
  return options;
}

}  // namespace v0
}  // namespace topobag
