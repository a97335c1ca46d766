// SPDX-License-Identifier: MIT
#include "calibration_report.hpp"

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
          {"warning", carry_over ? Json() : Json(carry_over.reason)}};
}

std::string calibration_lines(const CalibratedRun& calibrated) {
  const topobag::Calibration& calibration = calibrated.calibration;
  const auto threshold = calibration.threshold(calibrated.false_accept_rate, calibrated.places);
  std::ostringstream out;
  out << "  threshold     " << std::fixed << std::setprecision(2) << threshold.score
      << " for a false-accept rate of " << std::defaultfloat << std::setprecision(6)
      << calibrated.false_accept_rate << (threshold.extrapolated ? ", extrapolated" : "")
      << " from " << calibration.queries() << " queries (" << to_string(calibration.source())
      << ")\n";
  if (!calibrated.looks.empty()) out << "  looks         " << calibrated.looks << '\n';
  const topobag::CarryOver carry_over = calibration.carries_over();
  if (!carry_over) out << "  warning       " << carry_over.reason << '\n';
  return out.str();
}

}  // namespace program
