// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "look_up.hpp"
#include "recognition_options.hpp"

namespace program {

struct CalibrationArguments {
  bool calibrate = false;
  double false_accept_rate = 0.01;
  std::vector<std::string> other_places;  ///< tables
};

/// Adds `--calibrate` and what goes with it.
void add_calibration_options(CLI::App& command, CalibrationArguments& arguments);

/// What was asked for, with the tables of other places read as the queries are. Throws InputError.
std::optional<CalibrationRequest> calibration_request(const CalibrationArguments& arguments,
                                                      const RecognitionArguments& recognition);

}  // namespace program
