// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "json_output.hpp"
#include "recognition_run.hpp"

namespace program {

/// What a calibrated decision rests on, for machines.
Json calibration_json(const CalibratedRun& calibrated);

/// The same for a reader: a line, one on looks where they were to be learnt, and one where it may
/// not hold elsewhere.
std::string calibration_lines(const CalibratedRun& calibrated);

}  // namespace program
