// SPDX-License-Identifier: MIT
#include <map>
#include <string>
#include <utility>

#include <topobag/recognition/calibrate.hpp>
#include <topobag/recognition/calibration_text.hpp>

#include "fields.hpp"
#include "rooms.hpp"

namespace python {

void bind_calibration(py::module_& module) {
  using namespace topobag;
  py::class_<FalseAcceptRate> rate(module, "FalseAcceptRate", doc("FalseAcceptRate"));
  Attributes(rate, "FalseAcceptRate")
      .attribute("rate", &FalseAcceptRate::rate)
      .attribute("extrapolated", &FalseAcceptRate::extrapolated);
  py::class_<ScoreThreshold> threshold(module, "ScoreThreshold", doc("ScoreThreshold"));
  Attributes(threshold, "ScoreThreshold")
      .attribute("score", &ScoreThreshold::score)
      .attribute("extrapolated", &ScoreThreshold::extrapolated);
  py::class_<CarryOver> carry(module, "CarryOver", doc("CarryOver"));
  Attributes(carry, "CarryOver")
      .attribute("repeats", &CarryOver::repeats)
      .attribute("reason", &CarryOver::reason);
  carry.def("__bool__", [](const CarryOver& c) { return static_cast<bool>(c); });
  py::class_<AskedPlaces> asked(module, "AskedPlaces", doc("AskedPlaces"));
  Attributes(asked, "AskedPlaces")
      .attribute("queries", &AskedPlaces::queries)
      .attribute("places", &AskedPlaces::places)
      .attribute("mean", &AskedPlaces::mean);
  py::enum_<CalibrationSource>(module, "CalibrationSource", doc("CalibrationSource"))
      .value("null_model", CalibrationSource::null_model)
      .value("certain_negatives", CalibrationSource::certain_negatives);
  Fields<CalibrationOptions>(module, "CalibrationOptions")
      .field("min_negatives", &CalibrationOptions::min_negatives)
      .field("prior", &CalibrationOptions::prior)
      .field("max_repeats", &CalibrationOptions::max_repeats);
  Fields<PoseNegativeOptions>(module, "PoseNegativeOptions")
      .field("max_translation", &PoseNegativeOptions::max_translation)
      .field("max_rotation", &PoseNegativeOptions::max_rotation)
      .field("min_time_gap", &PoseNegativeOptions::min_time_gap)
      .field("min_id_gap", &PoseNegativeOptions::min_id_gap);
  Fields<CalibrateOptions>(module, "CalibrateOptions")
      .field("null_queries", &CalibrateOptions::null_queries)
      .field("seed", &CalibrateOptions::seed)
      .field("by_pose", &CalibrateOptions::by_pose)
      .field("calibration", &CalibrateOptions::calibration)
      .field("on_query", &CalibrateOptions::on_query)
      .field("appearance", &CalibrateOptions::appearance);
  py::class_<Calibration> calibration(module, "Calibration", doc("Calibration"));
  Attributes(calibration, "Calibration")
      .attribute("negatives", &Calibration::negatives)
      .attribute("source", &Calibration::source)
      .attribute("queries", &Calibration::queries)
      .attribute("repeats", &Calibration::repeats)
      .attribute("asked_places", &Calibration::asked_places);
  const auto to_text = [](const Calibration& c) { return topobag::to_string(c); };
  const auto from_text = [](const std::string& text) { return parse_calibration(text); };
  calibration
      .def(py::init<const CalibrationOptions&>(),
           py::arg_v("options", CalibrationOptions(), "CalibrationOptions()"),
           doc("Calibration.Calibration"))
      .def("add_negative", &Calibration::add_negative, py::arg("score"),
           py::arg("beyond_chance") = false, py::arg("places") = 0, doc("Calibration.add_negative"))
      .def("add_null", &Calibration::add_null, py::arg("score"), py::arg("places") = 0,
           doc("Calibration.add_null"))
      .def("threshold", &Calibration::threshold, py::arg("false_accept_rate"),
           py::arg("places") = 0, doc("Calibration.threshold"))
      .def("false_accept_rate", &Calibration::false_accept_rate, py::arg("score"),
           py::arg("places") = 0, doc("Calibration.false_accept_rate"))
      .def("probability", &Calibration::probability, py::arg("score"), py::arg("places") = 0,
           doc("Calibration.probability"))
      .def("is_extrapolated", &Calibration::is_extrapolated, py::arg("score"),
           doc("Calibration.is_extrapolated"))
      .def("carries_over", &Calibration::carries_over, doc("Calibration.carries_over"))
      .def_property(
          "conditions", [](const Calibration& c) { return c.conditions().stated(); },
          [](Calibration& c, const std::map<std::string, std::string>& stated) {
            CalibrationConditions conditions;
            for (const auto& [name, value] : stated) conditions.set(name, value);
            c.set_conditions(std::move(conditions));
          },
          doc("CalibrationConditions"))
      .def("to_text", to_text, "As a text, from which `from_text` makes the same one.")
      .def_static("from_text", from_text, py::arg("text"), doc("parse_calibration"))
      .def(py::pickle(to_text, from_text))
      .def("__repr__", [](const Calibration& c) {
        return "<Calibration of " + std::to_string(c.queries()) + " queries, " +
               topobag::to_string(c.source()) + ">";
      });
}

}  // namespace python
