// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "look_up.hpp"
#include "recognition_options.hpp"

namespace program {

struct CalibrationArguments {
  bool calibrate = false;
  double false_accept_rate = CalibrationRequest{}.false_accept_rate;
  std::vector<std::string> other_places;  ///< tables
  std::string saved;                      ///< file of a calibration; empty = none
  std::string to_save;                    ///< file to write one to; empty = none
};

/// Adds `--false-accept-rate`, `--calibrate`, `--calibration` and what goes with them.
void add_calibration_options(CLI::App& command, CalibrationArguments& arguments);

/// What was asked for, with its files read and the tables of other places read as the queries are.
/// Throws InputError, as for what was learnt with graphs that are made otherwise than the run's.
CalibrationRequest calibration_request(const CalibrationArguments& arguments,
                                       const RecognitionArguments& recognition,
                                       const RecognitionRun& run);

/// Writes what the run learnt where it was asked for. Throws InputError.
void save_calibration(const CalibrationArguments& arguments, const RecognitionRun& run);

}  // namespace program
