// SPDX-License-Identifier: MIT
#include "recognition_options.hpp"

#include <iostream>
#include <limits>

#include "input_error.hpp"
#include "number_check.hpp"
#include "recognition_report.hpp"

namespace program {
namespace {

void add_number(CLI::App& command, const char* name, double& value, const char* description,
                double max = std::numeric_limits<double>::infinity()) {
  command.add_option(name, value, description)
      ->check(number_within(0.0, max))
      ->capture_default_str();
}

}  // namespace

void add_keyframe_options(CLI::App& command, KeyframeOptions& keyframes, ImageSize& image_size) {
  add_camera_option(command, "--camera", keyframes.camera,
                    "Intrinsics fx,fy,cx,cy[,width,height], px")
      ->required();
  add_image_size_option(command, image_size);
  add_number(command, "--keyframe-interval", keyframes.interval,
             "From key frame to key frame, s; 0 = all");
  add_number(command, "--window", keyframes.window,
             "Key frames fused in one graph, s; 0 = single frames");
  add_number(command, "--min-confidence", keyframes.min_confidence, "Least score of a detection",
             1.0);
}

void add_recognition_options(CLI::App& command, RecognitionArguments& arguments) {
  add_keyframe_options(command, arguments.keyframes, arguments.image_size);
  topobag::PoseLimits& limits = arguments.scoring.limits;
  add_number(command, "--correct-translation", limits.correct_translation_m, "Correct up to, m");
  add_number(command, "--correct-rotation", limits.correct_rotation_deg, "Correct up to, degrees",
             180.0);
  add_number(command, "--wrong-translation", limits.wrong_translation_m, "Wrong beyond, m");
  add_number(command, "--wrong-rotation", limits.wrong_rotation_deg, "Wrong beyond, degrees",
             180.0);
  command.add_flag("--different-places", arguments.scoring.different_places,
                   "The sequences share no place: every accepted match is wrong");
  command.add_flag("--json", arguments.json, "Report in JSON");
  command.add_flag("--verbose", arguments.verbose, "A line for each key frame")->excludes("--json");
}

topobag::RecognitionOptions table_recognition_options() {
  topobag::RecognitionOptions options;
  options.matching.consistency.classes =
      topobag::lookalike_classes(topobag::ClassCatalog::coco80());
  return options;
}

void require_order(const topobag::PoseLimits& limits) {
  if (limits.wrong_translation_m < limits.correct_translation_m) {
    throw InputError("--wrong-translation", "wrong begins below where correct ends");
  }
  if (limits.wrong_rotation_deg < limits.correct_rotation_deg) {
    throw InputError("--wrong-rotation", "wrong begins below where correct ends");
  }
}

void print_report(const RecognitionRun& run, const RecognitionArguments& arguments) {
  if (arguments.json) {
    std::cout << to_json(run);
    return;
  }
  std::cout << to_table(run, arguments.scoring.limits);
  if (arguments.verbose) std::cout << '\n' << to_lines(run);
}

}  // namespace program
