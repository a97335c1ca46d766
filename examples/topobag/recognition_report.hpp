// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "recognition_run.hpp"

namespace program {

/// In a word.
const char* to_string(topobag::PoseVerdict verdict);

/// "median 1.20 ms, mean …": what queries took.
std::string times_text(const QueryTimes& ms);

/// A scored run for machines: the figures and every accepted match.
std::string to_json(const RecognitionRun& run);

/// The figures for a reader.
std::string to_table(const RecognitionRun& run, const topobag::PoseLimits& limits);

/// A line for each key frame that was looked up: what was found, and why or why not.
std::string to_lines(const RecognitionRun& run);

}  // namespace program
