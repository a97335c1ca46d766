// SPDX-License-Identifier: MIT
#include <topobag/recognition/loop_detector.hpp>
#include <topobag/recognition/recognition.hpp>
#include <topobag/recognition/recognition_options.hpp>

#include "described_catalog.hpp"
#include "fields.hpp"
#include "rooms.hpp"

namespace python {
namespace {

using namespace topobag;

void bind_options(py::module_& module) {
  Fields<DecisionOptions>(module, "DecisionOptions")
      .field("false_accept_rate", &DecisionOptions::false_accept_rate)
      .field("min_lead", &DecisionOptions::min_lead)
      .field("lead_deviations", &DecisionOptions::lead_deviations)
      .field("rival_support", &DecisionOptions::rival_support)
      .field("more_places", &DecisionOptions::more_places)
      .field("surplus", &DecisionOptions::surplus)
      .field("surplus_without_views", &DecisionOptions::surplus_without_views)
      .field("calibration", &DecisionOptions::calibration)
      .field("min_score", &DecisionOptions::min_score)
      .def("threshold", &DecisionOptions::threshold, py::arg("places"),
           py::arg("with_views") = true, py::arg("map_places") = 0,
           doc("DecisionOptions.threshold"));
  Fields<RecognitionOptions>(module, "RecognitionOptions")
      .field("retrieval", &RecognitionOptions::retrieval)
      .field("matching", &RecognitionOptions::matching)
      .field("place", &RecognitionOptions::place)
      .field("decision", &RecognitionOptions::decision);
  module.def(
      "recognition_options",
      [](const ClassesArgument& catalog, const SensorProfile& sensor) {
        const program::ObjectClasses classes = object_classes(catalog);
        RecognitionOptions options = recognition_options(classes.catalog, sensor);
        options.matching.consistency.classes = classes.lookalikes;
        return options;
      },
      py::arg("catalog"), py::arg_v("sensor", SensorProfile(), "SensorProfile()"),
      "The defaults for nodes with the labels of a catalog, as a sensor sees them; of a "
      "DescribedCatalog with the classes that look alike.");
  Fields<LoopOptions>(module, "LoopOptions")
      .field("min_gap", &LoopOptions::min_gap)
      .field("recognition", &LoopOptions::recognition);
}

}  // namespace

void bind_recognition(py::module_& module) {
  bind_options(module);
  py::enum_<Verdict>(module, "Verdict", doc("Verdict"))
      .value("no_agreement", Verdict::no_agreement, doc("Verdict.no_agreement"))
      .value("insignificant", Verdict::insignificant, doc("Verdict.insignificant"))
      .value("degenerate", Verdict::degenerate, doc("Verdict.degenerate"))
      .value("ambiguous", Verdict::ambiguous, doc("Verdict.ambiguous"))
      .value("rivalled", Verdict::rivalled, doc("Verdict.rivalled"))
      .value("not_best", Verdict::not_best, doc("Verdict.not_best"))
      .value("accepted", Verdict::accepted);
  py::class_<RivalPlace> rival(module, "RivalPlace", doc("RivalPlace"));
  Attributes(rival, "RivalPlace")
      .attribute("id", &RivalPlace::id)
      .attribute("support", &RivalPlace::support)
      .attribute("lead", &RivalPlace::lead)
      .attribute("T_candidate_query", &RivalPlace::T_candidate_query)
      .attribute("T_world_query", &RivalPlace::T_world_query);
  py::class_<CandidateReport> report(module, "CandidateReport", doc("CandidateReport"));
  Attributes(report, "CandidateReport")
      .attribute("id", &CandidateReport::id)
      .attribute("similarity", &CandidateReport::similarity)
      .attribute("verdict", &CandidateReport::verdict)
      .attribute("pose", &CandidateReport::pose)
      .attribute("other_poses", &CandidateReport::other_poses)
      .attribute("matched", &CandidateReport::matched)
      .attribute("place_support", &CandidateReport::place_support)
      .attribute("place_share", &CandidateReport::place_share)
      .attribute("rival", &CandidateReport::rival)
      .attribute("judged_by", &CandidateReport::judged_by)
      .attribute("places", &CandidateReport::places)
      .attribute("with_views", &CandidateReport::with_views)
      .attribute("threshold", &CandidateReport::threshold)
      .attribute("confidence", &CandidateReport::confidence)
      .attribute("complete", &CandidateReport::complete)
      .attribute("support", &CandidateReport::support)
      .attribute("score", &CandidateReport::score)
      .attribute("margin", &CandidateReport::margin);
  report.def("__repr__", [](const CandidateReport& r) {
    return "<CandidateReport of key frame " + std::to_string(value(r.id)) + ": " +
           to_string(r.verdict) + ", score " + std::to_string(r.score()) + ">";
  });
  py::class_<Recognition> recognition(module, "Recognition", doc("Recognition"));
  Attributes(recognition, "Recognition")
      .attribute("accepted", &Recognition::accepted)
      .attribute("candidates", &Recognition::candidates)
      .attribute("usable", &Recognition::usable)
      .attribute("places", &Recognition::places);
  recognition
      .def(
          "__bool__", [](const Recognition& r) { return static_cast<bool>(r); },
          "Whether a candidate was accepted.")
      .def("__repr__", [](const Recognition& r) {
        return "<Recognition: " +
               (r ? "key frame " + std::to_string(value(r.accepted->id)) : std::string("nothing")) +
               " of " + std::to_string(r.candidates.size()) + " candidates>";
      });
}

}  // namespace python
