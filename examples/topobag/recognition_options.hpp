// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>

#include <topobag/recognition/relocalizer.hpp>

#include "camera_option.hpp"
#include "keyframe_graphs.hpp"
#include "recognition_run.hpp"

namespace program {

/// What `localize` and `loops` have in common.
struct RecognitionArguments {
  KeyframeOptions keyframes;
  ImageSize image_size;
  Scoring scoring;
  bool json = false;
  bool verbose = false;
};

/// Adds `--camera` and what says how key frames become graphs.
void add_keyframe_options(CLI::App& command, KeyframeOptions& keyframes, ImageSize& image_size);

/// Adds the key frames' options, the limits of the scoring and the forms of the report.
void add_recognition_options(CLI::App& command, RecognitionArguments& arguments);

/// The library's defaults, for the classes of a node table.
topobag::RecognitionOptions table_recognition_options();

/// Throws InputError where a match would be correct and wrong at once.
void require_order(const topobag::PoseLimits& limits);

/// Prints a scored run to stdout.
void print_report(const RecognitionRun& run, const RecognitionArguments& arguments);

}  // namespace program
