// SPDX-License-Identifier: MIT
#include <string>
#include <vector>

#include <topobag/graph/local_graph_options.hpp>
#include <topobag/matching/layout_prior_text.hpp>
#include <topobag/matching/learn_layouts.hpp>
#include <topobag/matching/match_options.hpp>
#include <topobag/matching/size_prior_text.hpp>
#include <topobag/matching/usual_layouts.hpp>
#include <topobag/recognition/recognition_options.hpp>

#include "fields.hpp"
#include "rooms.hpp"

namespace python {
namespace {

using namespace topobag;

void bind_layouts(py::module_& module) {
  py::class_<LayoutPrior>(module, "LayoutPrior", doc("LayoutPrior"))
      .def(py::init<>())
      .def_readwrite("even", &LayoutPrior::even, doc("LayoutPrior.even"))
      .def_readwrite("pooled", &LayoutPrior::pooled, doc("LayoutPrior.pooled"))
      .def("density", &LayoutPrior::density, py::arg("a"), py::arg("b"), py::arg("distance"),
           py::arg("extent"), py::arg("level"), doc("LayoutPrior.density"))
      .def(
          "to_text", [](const LayoutPrior& p) { return topobag::to_string(p); },
          "As a text, from which `from_text` makes the same one.")
      .def_static(
          "from_text", [](const std::string& text) { return parse_layout_prior(text); },
          py::arg("text"), doc("parse_layout_prior"))
      .def(py::pickle([](const LayoutPrior& p) { return topobag::to_string(p); },
                      [](const std::string& text) { return parse_layout_prior(text); }));
  module.def("learn_layouts", &learn_layouts<TopologyGraph<>>, py::arg("places"),
             py::arg("prior") = LayoutPrior(), doc("learn_layouts"));
  module.def("usual_layouts", &usual_layouts, py::arg("catalog"), doc("usual_layouts"));
}

void bind_chance(py::module_& module) {
  Fields<SizeSpread>(module, "SizeSpread")
      .field("within", &SizeSpread::within)
      .field("between", &SizeSpread::between);
  Fields<SizePrior>(module, "SizePrior")
      .field("deviation", &SizePrior::deviation)
      .field("outliers", &SizePrior::outliers)
      .field("spread", &SizePrior::spread)
      .field("classes", &SizePrior::classes)
      .def(
          "to_text", [](const SizePrior& p) { return topobag::to_string(p); },
          "As a text, from which `from_text` makes the same one.")
      .def_static(
          "from_text", [](const std::string& text) { return parse_size_prior(text); },
          py::arg("text"), doc("parse_size_prior"));
  Fields<ChanceModel>(module, "ChanceModel")
      .field("fill", &ChanceModel::fill)
      .field("min_extent", &ChanceModel::min_extent)
      .field("height_spread", &ChanceModel::height_spread)
      .field("sizes", &ChanceModel::sizes)
      .field("relabeling", &ChanceModel::relabeling)
      .field("affinity", &ChanceModel::affinity)
      .field("appearance", &ChanceModel::appearance)
      .field("layouts", &ChanceModel::layouts);
}

void bind_place_options(py::module_& module) {
  Fields<LocalGraphOptions>(module, "LocalGraphOptions")
      .field("window", &LocalGraphOptions::window)
      .field("gate", &LocalGraphOptions::gate)
      .field("other_class_gate", &LocalGraphOptions::other_class_gate)
      .field("merge", &LocalGraphOptions::merge)
      .field("merge_gate", &LocalGraphOptions::merge_gate)
      .field("correlation", &LocalGraphOptions::correlation)
      .field("image_margin", &LocalGraphOptions::image_margin)
      .field("max_depth", &LocalGraphOptions::max_depth)
      .field("min_existence", &LocalGraphOptions::min_existence);
  Fields<PlaceOptions>(module, "PlaceOptions")
      .field("max_hypotheses", &PlaceOptions::max_hypotheses)
      .field("max_rivals", &PlaceOptions::max_rivals)
      .field("min_score", &PlaceOptions::min_score)
      .field("distinct_translation", &PlaceOptions::distinct_translation)
      .field("distinct_rotation", &PlaceOptions::distinct_rotation)
      .field("min_id_gap", &PlaceOptions::min_id_gap)
      .field("max_followed", &PlaceOptions::max_followed)
      .field("max_keyframes", &PlaceOptions::max_keyframes)
      .field("radius", &PlaceOptions::radius)
      .field("turn_weight", &PlaceOptions::turn_weight)
      .field("spacing", &PlaceOptions::spacing)
      .field("max_neighbors", &PlaceOptions::max_neighbors)
      .field("max_contradiction", &PlaceOptions::max_contradiction)
      .field("margin", &PlaceOptions::margin)
      .field("max_depth", &PlaceOptions::max_depth)
      .field("fusing", &PlaceOptions::fusing);
}

void bind_agreement(py::module_& module) {
  py::class_<ClassGroups>(module, "ClassGroups", doc("ClassGroups"))
      .def(py::init<>())
      .def("join", &ClassGroups::join, py::arg("a"), py::arg("b"), doc("ClassGroups.join"))
      .def("group", &ClassGroups::group, py::arg("label"), doc("ClassGroups.group"))
      .def("members", &ClassGroups::members, py::arg("label"), doc("ClassGroups.members"))
      .def("compatible", &ClassGroups::compatible, py::arg("a"), py::arg("b"),
           doc("ClassGroups.compatible"));
  module.def("lookalike_classes", &lookalike_classes, py::arg("catalog"), doc("lookalike_classes"));
  Fields<ConsistencyOptions>(module, "ConsistencyOptions")
      .field("classes", &ConsistencyOptions::classes)
      .field("affinity", &ConsistencyOptions::affinity)
      .field("min_affinity", &ConsistencyOptions::min_affinity)
      .field("max_size_ratio", &ConsistencyOptions::max_size_ratio)
      .field("deviations", &ConsistencyOptions::deviations)
      .field("min_tolerance", &ConsistencyOptions::min_tolerance)
      .field("max_tolerance", &ConsistencyOptions::max_tolerance)
      .field("max_pairs", &ConsistencyOptions::max_pairs);
  Fields<ViewpointPrior>(module, "ViewpointPrior")
      .field("share", &ViewpointPrior::share)
      .field("deviation", &ViewpointPrior::deviation);
  Fields<RefineOptions>(module, "RefineOptions")
      .field("iterations", &RefineOptions::iterations)
      .field("tolerance", &RefineOptions::tolerance)
      .field("kernel_width", &RefineOptions::kernel_width);
  Fields<MissingObjects>(module, "MissingObjects")
      .field("max_detection_rate", &MissingObjects::max_detection_rate)
      .field("correlation", &MissingObjects::correlation)
      .field("min_probability", &MissingObjects::min_probability)
      .field("image_margin", &MissingObjects::image_margin)
      .field("max_depth", &MissingObjects::max_depth)
      .field("same_spot", &MissingObjects::same_spot)
      .field("same_spot_share", &MissingObjects::same_spot_share)
      .field("clearance", &MissingObjects::clearance)
      .field("detection_rates", &MissingObjects::detection_rates);
}

}  // namespace

void bind_match_options(py::module_& module) {
  bind_agreement(module);
  bind_layouts(module);
  bind_chance(module);
  bind_place_options(module);
  Fields<ScaleRange>(module, "ScaleRange")
      .field("least", &ScaleRange::least)
      .field("greatest", &ScaleRange::greatest)
      .field("max_tried", &ScaleRange::max_tried)
      .field("max_deviation", &ScaleRange::max_deviation);
  Fields<MatchOptions>(module, "MatchOptions")
      .field("consistency", &MatchOptions::consistency)
      .field("chance", &MatchOptions::chance)
      .field("missing", &MatchOptions::missing)
      .field("viewpoint", &MatchOptions::viewpoint)
      .field("refine", &MatchOptions::refine)
      .field("max_steps", &MatchOptions::max_steps)
      .field("slack", &MatchOptions::slack)
      .field("max_hypotheses", &MatchOptions::max_hypotheses)
      .field("min_promise", &MatchOptions::min_promise)
      .field("inlier_deviations", &MatchOptions::inlier_deviations)
      .field("max_residual", &MatchOptions::max_residual)
      .field("min_spread", &MatchOptions::min_spread)
      .field("max_rotation_deviation", &MatchOptions::max_rotation_deviation)
      .field("distinct_translation", &MatchOptions::distinct_translation)
      .field("distinct_rotation", &MatchOptions::distinct_rotation)
      .field("scale", &MatchOptions::scale);
}

}  // namespace python
