// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "look_up.hpp"
#include "recognition_run.hpp"

namespace program {

/// Learns from the map of a run, and from other places: first what looks say, then the scores that
/// false matches reach. Throws InputError where the other places' key frames are the map's own.
/// @param min_gap  s; a key frame with a pose is not looked up among those nearer in time
CalibratedRun learnt_calibration(const RecognitionRun& run, const CalibrationRequest& request,
                                 std::optional<double> min_gap);

}  // namespace program
