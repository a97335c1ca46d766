// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>

#include <topobag/adaptors/orb_slam.hpp>

#include "adaptors/small_host.hpp"

namespace small_host {

using Database = topobag::OrbSlamDatabase<KeyFrame, Frame, Map>;

/// A loop query does not wait for its sighting.
inline topobag::OrbSlamOptions without_waiting() {
  topobag::OrbSlamOptions options;
  options.loop_wait = std::chrono::milliseconds(0);
  return options;
}

}  // namespace small_host
