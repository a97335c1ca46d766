// SPDX-License-Identifier: MIT
#include "calibration_options.hpp"

#include <iterator>
#include <utility>

#include <topobag/recognition/calibration_text.hpp>

#include "csv_reader.hpp"
#include "input_error.hpp"
#include "learning_conditions.hpp"
#include "number_check.hpp"
#include "output_files.hpp"

namespace program {

void add_calibration_options(CLI::App& command, CalibrationArguments& arguments) {
  command
      .add_option("--false-accept-rate", arguments.false_accept_rate,
                  "Share of queries of other places that may be accepted")
      ->check(number_within(1e-12, 1.0))
      ->capture_default_str();
  CLI::Option* calibrate = command.add_flag(
      "--calibrate", arguments.calibrate,
      "Learn from the map, by its poses where it has them, what scores false matches reach");
  command
      .add_option("--other-place", arguments.other_places,
                  "Table of key frames that are certainly not of the map, to learn from")
      ->needs(calibrate);
  add_output_option(command, "--save-calibration", arguments.to_save,
                    "File to write what was learnt to")
      ->needs(calibrate);
  command.add_option("--calibration", arguments.saved, "File of what was learnt before")
      ->excludes(calibrate);
}

CalibrationRequest calibration_request(const CalibrationArguments& arguments,
                                       const RecognitionArguments& recognition,
                                       const RecognitionRun& run) {
  CalibrationRequest request;
  request.conditions = learning_conditions(run, recognition.keyframes);
  request.false_accept_rate = arguments.false_accept_rate;
  request.learn = arguments.calibrate;
  if (!arguments.saved.empty()) {
    try {
      request.learnt = topobag::parse_calibration(read_file(arguments.saved));
    } catch (const topobag::FormatError& error) {
      std::string why = error.what();
      if (why.back() == '.') why.pop_back();
      throw InputError(arguments.saved, why + "; give a file that --save-calibration wrote");
    }
    require_conditions(arguments.saved, *request.learnt, request.conditions);
  }
  KeyframeOptions options = recognition.keyframes;
  options.classes = run.classes;
  options.camera = with_size(options.camera, recognition.image_size);
  for (const std::string& set : arguments.other_places) {
    std::vector<Keyframe> keyframes = read_keyframes(set, options);
    request.other_places.insert(request.other_places.end(),
                                std::make_move_iterator(keyframes.begin()),
                                std::make_move_iterator(keyframes.end()));
  }
  return request;
}

void save_calibration(const CalibrationArguments& arguments, const RecognitionRun& run) {
  if (arguments.to_save.empty() || !run.calibrated) return;
  write_file(arguments.to_save, to_string(run.calibrated->calibration));
}

}  // namespace program
