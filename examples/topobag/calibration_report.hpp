// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "json_output.hpp"
#include "recognition_run.hpp"

namespace program {

/// What a calibrated decision rests on, for machines.
Json calibration_json(const CalibratedRun& calibrated);

/// Which score is asked for and why, in words.
std::string threshold_text(const CalibratedRun& calibrated);

/// That it was learnt with another map, and of how many places; empty where it was with this one,
/// or does not say.
std::string other_map_text(const CalibratedRun& calibrated);

/// The same for a reader: a line, one on looks where they were to be learnt, one where it is of
/// another map, and one where it may not hold elsewhere.
std::string calibration_lines(const CalibratedRun& calibrated);

}  // namespace program
