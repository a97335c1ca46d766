// SPDX-License-Identifier: MIT
#include <topobag/recognition/explanation.hpp>
#include <topobag/recognition/temporal_consistency.hpp>
#include <topobag/recognition/why.hpp>

#include <pybind11/eigen.h>

#include "fields.hpp"
#include "rooms.hpp"

namespace python {
namespace {

using namespace topobag;

void bind_changes(py::module_& module) {
  py::enum_<ChangeKind>(module, "ChangeKind", doc("ChangeKind"))
      .value("moved", ChangeKind::moved, doc("ChangeKind.moved"))
      .value("appeared", ChangeKind::appeared, doc("ChangeKind.appeared"))
      .value("gone", ChangeKind::gone, doc("ChangeKind.gone"));
  py::class_<ObjectChange> change(module, "ObjectChange", doc("ObjectChange"));
  Attributes(change, "ObjectChange")
      .attribute("kind", &ObjectChange::kind)
      .attribute("label", &ObjectChange::label)
      .attribute("candidate", &ObjectChange::candidate)
      .attribute("query", &ObjectChange::query)
      .attribute("before", &ObjectChange::before)
      .attribute("after", &ObjectChange::after);
  Fields<CoincidenceOptions>(module, "CoincidenceOptions")
      .field("deviations", &CoincidenceOptions::deviations)
      .field("max_distance", &CoincidenceOptions::max_distance);
  Fields<ChangeOptions>(module, "ChangeOptions")
      .field("classes", &ChangeOptions::classes)
      .field("unchanged", &ChangeOptions::unchanged)
      .field("max_move", &ChangeOptions::max_move);
  module.def("what_changed", &what_changed<double>, py::arg("candidate"), py::arg("query"),
             py::arg("pose"), py::arg_v("options", ChangeOptions(), "ChangeOptions()"),
             py::call_guard<py::gil_scoped_release>(), doc("what_changed"));
}

void bind_parts(py::module_& module) {
  py::class_<ExplainedStage> stage(module, "ExplainedStage", doc("ExplainedStage"));
  Attributes(stage, "ExplainedStage")
      .attribute("name", &ExplainedStage::name)
      .attribute("passed", &ExplainedStage::passed)
      .attribute("value", &ExplainedStage::value)
      .attribute("asked", &ExplainedStage::asked)
      .attribute("at_least", &ExplainedStage::at_least)
      .attribute("unit", &ExplainedStage::unit)
      .attribute("missed_by", &ExplainedStage::missed_by);
  py::class_<ExplainedMatch> match(module, "ExplainedMatch", doc("ExplainedMatch"));
  Attributes(match, "ExplainedMatch")
      .attribute("candidate", &ExplainedMatch::candidate)
      .attribute("query", &ExplainedMatch::query)
      .attribute("candidate_class", &ExplainedMatch::candidate_class)
      .attribute("query_class", &ExplainedMatch::query_class)
      .attribute("distance", &ExplainedMatch::distance)
      .attribute("deviations", &ExplainedMatch::deviations)
      .attribute("looks", &ExplainedMatch::looks);
  py::class_<ExplainedMissing> missing(module, "ExplainedMissing", doc("ExplainedMissing"));
  Attributes(missing, "ExplainedMissing")
      .attribute("node", &ExplainedMissing::node)
      .attribute("of_candidate", &ExplainedMissing::of_candidate)
      .attribute("class_name", &ExplainedMissing::class_name)
      .attribute("position", &ExplainedMissing::position)
      .attribute("views", &ExplainedMissing::views)
      .attribute("measured_views", &ExplainedMissing::measured_views)
      .attribute("cost", &ExplainedMissing::cost);
  py::class_<ExplainedChange> change(module, "ExplainedChange", doc("ExplainedChange"));
  Attributes(change, "ExplainedChange")
      .attribute("change", &ExplainedChange::change)
      .attribute("class_name", &ExplainedChange::class_name);
}

void bind_temporal(py::module_& module) {
  Fields<TemporalOptions>(module, "TemporalOptions")
      .field("min_matches", &TemporalOptions::min_matches)
      .field("max_missed", &TemporalOptions::max_missed)
      .field("max_translation", &TemporalOptions::max_translation)
      .field("max_rotation", &TemporalOptions::max_rotation);
  py::class_<TemporalConsistency>(module, "TemporalConsistency", doc("TemporalConsistency"))
      .def(py::init<const TemporalOptions&, TemporalConsistency::SamePlace>(),
           py::arg_v("options", TemporalOptions(), "TemporalOptions()"),
           py::arg("same_place") = py::none(), doc("TemporalConsistency.TemporalConsistency"))
      .def("add", &TemporalConsistency::add<Recognition>, py::arg("recognition"),
           py::arg("T_previous_current") = py::none(), py::arg("T_world_candidate") = py::none(),
           doc("TemporalConsistency.add"))
      .def_property_readonly("matches", &TemporalConsistency::matches,
                             doc("TemporalConsistency.matches"))
      .def("reset", &TemporalConsistency::reset, doc("TemporalConsistency.reset"));
}

}  // namespace

void bind_explanation(py::module_& module) {
  bind_changes(module);
  bind_parts(module);
  py::class_<CandidateExplanation> candidate(module, "CandidateExplanation",
                                             doc("CandidateExplanation"));
  Attributes(candidate, "CandidateExplanation")
      .attribute("id", &CandidateExplanation::id)
      .attribute("verdict", &CandidateExplanation::verdict)
      .attribute("similarity", &CandidateExplanation::similarity)
      .attribute("confidence", &CandidateExplanation::confidence)
      .attribute("place_support", &CandidateExplanation::place_support)
      .attribute("rival", &CandidateExplanation::rival)
      .attribute("complete", &CandidateExplanation::complete)
      .attribute("stages", &CandidateExplanation::stages)
      .attribute("matched", &CandidateExplanation::matched)
      .attribute("missing", &CandidateExplanation::missing)
      .attribute("changes", &CandidateExplanation::changes);
  candidate.def("__str__", [](const CandidateExplanation& e) { return to_string(e); });
  py::class_<Explanation> explanation(module, "Explanation", doc("Explanation"));
  Attributes(explanation, "Explanation")
      .attribute("objects", &Explanation::objects)
      .attribute("usable", &Explanation::usable)
      .attribute("candidates", &Explanation::candidates);
  explanation.def("__str__", [](const Explanation& e) { return to_string(e); });
  module.def(
      "why", [](const Recognition& recognition) { return why(recognition); },
      py::arg("recognition"),
      "In one line why a query was or was not recognised: the accepted candidate's score, or the "
      "nearest one's and what was against it. For all candidates, stage by stage: explain.");
  bind_temporal(module);
}

}  // namespace python
