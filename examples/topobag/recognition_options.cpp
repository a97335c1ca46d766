// SPDX-License-Identifier: MIT
#include "recognition_options.hpp"

#include <iostream>
#include <limits>

#include "input_error.hpp"
#include "number_check.hpp"
#include "recognition_report.hpp"
#include "report/html_text.hpp"

namespace program {

void add_recognition_options(CLI::App& command, RecognitionArguments& arguments) {
  add_keyframe_options(command, arguments.keyframes, arguments.image_size);
  const auto number = [&](const char* name, double& value, const char* description, double max) {
    command.add_option(name, value, description)
        ->check(number_within(0.0, max))
        ->capture_default_str();
  };
  const double any = std::numeric_limits<double>::infinity();
  number("--query-interval", arguments.query_interval,
         "From one key frame that is looked up to the next, s; 0 = every key frame", any);
  topobag::PoseLimits& limits = arguments.scoring.limits;
  number("--correct-translation", limits.correct_translation_m, "Correct up to, m", any);
  number("--correct-rotation", limits.correct_rotation_deg, "Correct up to, degrees", 180.0);
  number("--wrong-translation", limits.wrong_translation_m, "Wrong beyond, m", any);
  number("--wrong-rotation", limits.wrong_rotation_deg, "Wrong beyond, degrees", 180.0);
  command.add_flag("--different-places", arguments.scoring.different_places,
                   "The sequences share no place: every accepted match is wrong");
  command
      .add_flag("--align-worlds", arguments.scoring.align_worlds,
                "The poses of map and queries are of two worlds: score by the one rigid motion "
                "between them that most accepted matches agree on")
      ->excludes("--different-places");
  command
      .add_option("--place-radius", arguments.scoring.place_radius,
                  "A match with a key frame whose camera was farther away is wrong, m [no limit]")
      ->check(number_within(0.0));
  command.add_flag("--json", arguments.json, "Report in JSON");
  command.add_flag("--verbose", arguments.verbose, "A line for each key frame")->excludes("--json");
}

void require_order(const topobag::PoseLimits& limits) {
  const auto require = [](const std::string& what, double correct, double wrong) {
    if (wrong >= correct) return;
    throw InputError("--wrong-" + what, "wrong begins at " + short_text(wrong) +
                                            ", below where correct ends, at " +
                                            short_text(correct) + "; give --wrong-" + what +
                                            " and --correct-" + what + " in their order");
  };
  require("translation", limits.correct_translation_m, limits.wrong_translation_m);
  require("rotation", limits.correct_rotation_deg, limits.wrong_rotation_deg);
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
