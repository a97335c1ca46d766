// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>

#include <topobag/error.hpp>

#include "sensor.hpp"

namespace semantic {

/// What the user gives to the program beside an ORB-SLAM.
struct Arguments {
  std::string vocabulary, settings, sequence, associations;
  std::string table, model;
  std::string sensor, depth;  ///< empty: by the other one, rgbd where both are
  std::string kidnap_sequence, kidnap_associations, kidnap_table;
  std::size_t kidnap_every = 12;
  double kidnap_window = 0.0;
  bool kidnap_without_depth = false;
  double window = 3.0;
  std::size_t max_places = 5;
  std::size_t candidates = 0;
  std::string out = ".";
  std::string load_sightings, save_sightings;
  double still = 0.0;  ///< m; 0 = every key frame is looked at
  bool mask = false;
  bool stock = false;
  bool no_wait = false;
};

/// The host's camera.
inline Sensor sensor_of(const Arguments& arguments) {
  const std::string& name =
      arguments.sensor.empty() && arguments.depth == "stereo" ? arguments.depth : arguments.sensor;
  return name == "stereo" ? Sensor::stereo : name == "mono" ? Sensor::mono : Sensor::rgbd;
}

/// Where the boxes get their depths from: "rgbd", "points" or "stereo". Throws topobag::Error for
/// depths that the camera does not have.
inline std::string depth_of(const Arguments& arguments) {
  const Sensor sensor = sensor_of(arguments);
  const std::string own = sensor == Sensor::rgbd     ? "rgbd"
                          : sensor == Sensor::stereo ? "stereo"
                                                     : "points";
  if (arguments.depth.empty() || arguments.depth == own) return own;
  if (arguments.depth == "points") return arguments.depth;
  throw topobag::Error("--sensor " + arguments.sensor + " has no --depth " + arguments.depth +
                       ": give " + (own == "points" ? own : own + " or points") +
                       ", or leave it out");
}

}  // namespace semantic
