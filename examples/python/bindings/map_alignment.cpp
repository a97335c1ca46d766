// SPDX-License-Identifier: MIT
#include <functional>
#include <optional>
#include <string>

#include <pybind11/eigen.h>

#include <topobag/recognition/align_maps.hpp>

#include "fields.hpp"
#include "map.hpp"
#include "rooms.hpp"

namespace python {
namespace {

using topobag::AlignmentVerdict;
using topobag::AlignOptions;
using topobag::MapAlignment;

/// Both maps as they are now. They are taken in one order whoever asks, so that no two who lay the
/// same maps over each other wait for one another.
MapAlignment aligned(const Map& a, const Map& b, const AlignOptions& options) {
  const Map& first = std::less<const Map*>()(&a, &b) ? a : b;
  const Map& second = &first == &a ? b : a;
  const auto first_view = first.view();
  const auto second_view = &a == &b ? first_view : second.view();
  return topobag::align_maps(*(&first == &a ? first_view : second_view),
                             *(&first == &a ? second_view : first_view), options);
}

std::optional<Eigen::Isometry3d> motion_between(const MapAlignment& alignment) {
  if (!alignment.T_a_b) return std::nullopt;
  return alignment.T_a_b->T;
}
std::optional<Eigen::Matrix<double, 6, 6>> its_covariance(const MapAlignment& alignment) {
  if (!alignment.T_a_b) return std::nullopt;
  return alignment.T_a_b->covariance;
}

}  // namespace

void bind_map_alignment(py::module_& module) {
  py::enum_<AlignmentVerdict>(module, "AlignmentVerdict", doc("AlignmentVerdict"))
      .value("aligned", AlignmentVerdict::aligned, doc("AlignmentVerdict.aligned"))
      .value("no_poses", AlignmentVerdict::no_poses, doc("AlignmentVerdict.no_poses"))
      .value("too_few", AlignmentVerdict::too_few, doc("AlignmentVerdict.too_few"))
      .value("ambiguous", AlignmentVerdict::ambiguous, doc("AlignmentVerdict.ambiguous"))
      .value("contradicted", AlignmentVerdict::contradicted, doc("AlignmentVerdict.contradicted"));
  Fields<AlignOptions>(module, "AlignOptions")
      .field("recognition", &AlignOptions::recognition)
      .field("max_keyframes", &AlignOptions::max_keyframes)
      .field("min_matches", &AlignOptions::min_matches)
      .field("max_rival_share", &AlignOptions::max_rival_share)
      .field("min_revisit_share", &AlignOptions::min_revisit_share)
      .field("deviations", &AlignOptions::deviations)
      .field("on_query", &AlignOptions::on_query);
  py::class_<MapAlignment> alignment(module, "MapAlignment", doc("MapAlignment"));
  Attributes(alignment, "MapAlignment")
      .attribute("verdict", &MapAlignment::verdict)
      .attribute("T_a_b", &motion_between)
      .attribute("scale", &MapAlignment::scale)
      .attribute("scale_deviation", &MapAlignment::scale_deviation)
      .attribute("scale_covariance", &MapAlignment::scale_covariance)
      .attribute("asked", &MapAlignment::asked)
      .attribute("matched", &MapAlignment::matched)
      .attribute("agreeing", &MapAlignment::agreeing)
      .attribute("rivalling", &MapAlignment::rivalling)
      .attribute("places", &MapAlignment::places)
      .attribute("revisiting", &MapAlignment::revisiting);
  alignment
      .def_property_readonly("covariance", &its_covariance,
                             "6 x 6, of the error of T_a_b: a translation (m) and a rotation "
                             "vector (rad), in this order and in a's world; None where no "
                             "alignment fits.")
      .def("merge_options", &MapAlignment::merge_options, py::arg("session_offset") = 0,
           doc("MapAlignment.merge_options"))
      .def(
          "__bool__", [](const MapAlignment& a) { return static_cast<bool>(a); },
          "Whether one alignment fits.")
      .def("__repr__", [](const MapAlignment& a) {
        return std::string("<MapAlignment: ") + topobag::why(a.verdict) + '>';
      });
  module.def(
      "why", [](AlignmentVerdict verdict) { return topobag::why(verdict); }, py::arg("verdict"),
      "In one sentence what became of two maps.");
  module.def("align_maps", &aligned, py::arg("a"), py::arg("b"),
             py::arg_v("options", AlignOptions(), "AlignOptions()"),
             py::call_guard<py::gil_scoped_release>(), doc("align_maps"));
}

}  // namespace python
