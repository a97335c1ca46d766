// SPDX-License-Identifier: MIT
#include "calibration_options.hpp"

#include <iterator>
#include <utility>

#include "number_check.hpp"

namespace program {

void add_calibration_options(CLI::App& command, CalibrationArguments& arguments) {
  CLI::Option* calibrate = command.add_flag(
      "--calibrate", arguments.calibrate,
      "Learn from the map what scores false matches reach, and accept by a false-accept rate");
  command
      .add_option("--false-accept-rate", arguments.false_accept_rate,
                  "Share of look-ups of other places that may be accepted")
      ->check(number_within(1e-12, 1.0))
      ->needs(calibrate)
      ->capture_default_str();
  command
      .add_option("--other-place", arguments.other_places,
                  "Table of key frames that are certainly not of the map, to learn from")
      ->needs(calibrate);
}

std::optional<CalibrationRequest> calibration_request(const CalibrationArguments& arguments,
                                                      const RecognitionArguments& recognition) {
  if (!arguments.calibrate) return std::nullopt;
  CalibrationRequest request{arguments.false_accept_rate, {}};
  KeyframeOptions options = recognition.keyframes;
  options.camera = with_size(options.camera, recognition.image_size);
  for (const std::string& set : arguments.other_places) {
    std::vector<Keyframe> keyframes = read_keyframes(set, options);
    request.other_places.insert(request.other_places.end(),
                                std::make_move_iterator(keyframes.begin()),
                                std::make_move_iterator(keyframes.end()));
  }
  return request;
}

}  // namespace program
