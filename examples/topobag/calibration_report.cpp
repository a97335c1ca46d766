// SPDX-License-Identifier: MIT
#include "calibration_report.hpp"

#include <cmath>
#include <iomanip>
#include <sstream>

namespace program {

Json calibration_json(const CalibratedRun& calibrated) {
  const topobag::Calibration& calibration = calibrated.calibration;
  const auto threshold = calibration.threshold(calibrated.false_accept_rate, calibrated.places);
  const topobag::CarryOver carry_over = calibration.carries_over();
  const topobag::AskedPlaces& asked = calibration.asked_places();
  return {{"false_accept_rate", calibrated.false_accept_rate},
          {"threshold", threshold.score},
          {"extrapolated", threshold.extrapolated},
          {"source", to_string(calibration.source())},
          {"queries", calibration.queries()},
          {"certain_negatives", calibration.negatives()},
          {"repeats", carry_over.repeats},
          {"learnt_looks", calibration.appearance().has_value()},
          {"places", calibrated.places},
          {"places_learnt", asked.queries > 0 ? Json(asked.mean()) : Json()},
          {"other_map", or_null(calibrated.other_map)},
          {"warning", carry_over ? Json() : Json(carry_over.reason)}};
}

std::string threshold_text(const CalibratedRun& calibrated) {
  const topobag::Calibration& calibration = calibrated.calibration;
  const auto threshold = calibration.threshold(calibrated.false_accept_rate, calibrated.places);
  std::ostringstream out;
  out << std::fixed << std::setprecision(2) << threshold.score << " for a false-accept rate of "
      << std::defaultfloat << std::setprecision(6) << calibrated.false_accept_rate
      << (threshold.extrapolated ? ", extrapolated" : "") << " from " << calibration.queries()
      << " queries (" << to_string(calibration.source()) << ")";
  return out.str();
}

std::string other_map_text(const CalibratedRun& calibrated) {
  if (!calibrated.other_map.value_or(false)) return "";
  const topobag::AskedPlaces& asked = calibrated.calibration.asked_places();
  if (asked.queries == 0) return "with another map";
  const long learnt = std::lround(asked.mean());
  return "with another map, of " + std::to_string(learnt) + (learnt == 1 ? " place" : " places") +
         "; this one has " + std::to_string(calibrated.places);
}

std::string calibration_lines(const CalibratedRun& calibrated) {
  std::string lines = "  threshold     " + threshold_text(calibrated) + '\n';
  if (!calibrated.looks.empty()) lines += "  looks         " + calibrated.looks + '\n';
  const std::string other = other_map_text(calibrated);
  if (!other.empty()) lines += "  learnt        " + other + '\n';
  const topobag::CarryOver carry_over = calibrated.calibration.carries_over();
  if (!carry_over) lines += "  warning       " + carry_over.reason + '\n';
  return lines;
}

}  // namespace program
