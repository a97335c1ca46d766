// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>

#include "keyframe_options.hpp"
#include "recognition_run.hpp"

namespace program {

/// What `localize` and `loops` have in common.
struct RecognitionArguments {
  KeyframeOptions keyframes;
  ImageSize image_size;
  Scoring scoring;
  double query_interval = 0.0;  ///< s from query to query; 0 = every key frame
  bool json = false;
  bool verbose = false;
};

/// Adds the key frames' options, which are looked up, what the scoring holds matches against, and
/// the forms of the report.
void add_recognition_options(CLI::App& command, RecognitionArguments& arguments);

/// Throws InputError where a match would be correct and wrong at once.
void require_order(const topobag::PoseLimits& limits);

/// Prints a scored run to stdout.
void print_report(const RecognitionRun& run, const RecognitionArguments& arguments);

}  // namespace program
