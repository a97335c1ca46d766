// SPDX-License-Identifier: MIT
#include <topobag/graph/scaled_graph.hpp>
#include <topobag/matching/match_graphs.hpp>
#include <topobag/matching/rigid_fit.hpp>

#include <pybind11/eigen.h>

#include "fields.hpp"
#include "node_array.hpp"
#include "rooms.hpp"

namespace python {
namespace {

using namespace topobag;
using Graph = TopologyGraph<>;

/// m × 2: node of the candidate, node of the query.
py::array_t<std::uint32_t> inliers_of(const RelativePose& pose) {
  py::array_t<std::uint32_t> pairs({static_cast<py::ssize_t>(pose.inliers.size()), py::ssize_t{2}});
  std::uint32_t* out = pairs.mutable_data();
  for (const Correspondence& pair : pose.inliers) {
    *out++ = static_cast<std::uint32_t>(pair.candidate);
    *out++ = static_cast<std::uint32_t>(pair.query);
  }
  return pairs;
}

Eigen::Matrix3Xd points_from(const ArrayLike& points, const char* name) {
  const auto given = numbers(points, name, {any, 3});
  const auto entry = given.unchecked<2>();
  Eigen::Matrix3Xd columns(3, given.shape(0));
  for (py::ssize_t i = 0; i < given.shape(0); ++i) {
    for (int k = 0; k < 3; ++k) columns(k, i) = entry(i, k);
  }
  if (!columns.allFinite())
    throw InvalidValue(std::string(name) + " holds a number that is not finite");
  return columns;
}

std::optional<RigidFit> fitted(const ArrayLike& target, const ArrayLike& source,
                               const std::optional<ArrayLike>& weights) {
  const Eigen::Matrix3Xd to = points_from(target, "target");
  const Eigen::Matrix3Xd from = points_from(source, "source");
  if (to.cols() != from.cols()) {
    throw InvalidValue("target has " + std::to_string(to.cols()) + " points, but source has " +
                       std::to_string(from.cols()));
  }
  Eigen::VectorXd each;
  if (weights) {
    const auto given = numbers(*weights, "weights", {any});
    require_rows(given, "weights", from.cols(), "points");
    const auto entry = given.unchecked<1>();
    each.resize(given.size());
    for (py::ssize_t i = 0; i < given.size(); ++i) each(i) = entry(i);
    if (!each.allFinite() || (each.array() <= 0.0).any()) {
      throw InvalidValue("weights are positive, finite numbers");
    }
  }
  return fit_rigid(to, from, each);
}

void bind_pose(py::module_& module) {
  py::class_<MissingObject> missing(module, "MissingObject", doc("MissingObject"));
  Attributes(missing, "MissingObject")
      .attribute("node", &MissingObject::node)
      .attribute("of_candidate", &MissingObject::of_candidate)
      .attribute("views", &MissingObject::views)
      .attribute("measured_views", &MissingObject::measured_views)
      .attribute("cost", &MissingObject::cost);
  py::class_<RelativePose> pose(module, "RelativePose", doc("RelativePose"));
  Attributes(pose, "RelativePose")
      .attribute("T_candidate_query", &RelativePose::T_candidate_query)
      .attribute("covariance", &RelativePose::covariance)
      .attribute("scale", &RelativePose::scale)
      .attribute("scale_deviation", &RelativePose::scale_deviation)
      .attribute("scale_covariance", &RelativePose::scale_covariance)
      .attribute("inliers", &inliers_of)
      .attribute("rms", &RelativePose::rms)
      .attribute("spread", &RelativePose::spread)
      .attribute("degenerate", &RelativePose::degenerate)
      .attribute("significance", &RelativePose::significance)
      .attribute("missing", &RelativePose::missing)
      .attribute("missing_cost", &RelativePose::missing_cost)
      .attribute("viewpoint_odds", &RelativePose::viewpoint_odds)
      .attribute("rotation_deviation", [](const RelativePose& p) { return p.rotation_deviation(); })
      .attribute("support", &RelativePose::support)
      .attribute("score", &RelativePose::score);
  pose.def(
          "__array__",
          [](const RelativePose& p, const py::object& dtype) {
            const py::object T = matrix_of(p.T_candidate_query);
            return dtype.is_none() ? T : py::object(T.attr("astype")(dtype));
          },
          py::arg("dtype") = py::none(), "T_candidate_query, 4 x 4.")
      .def("__repr__", [](const RelativePose& p) {
        return "<RelativePose: score " + std::to_string(p.score()) + ", " +
               std::to_string(p.inliers.size()) + " objects>";
      });
}

}  // namespace

void bind_matching(py::module_& module) {
  bind_pose(module);
  py::class_<GraphMatch> match(module, "GraphMatch", doc("GraphMatch"));
  Attributes(match, "GraphMatch")
      .attribute("poses", &GraphMatch::poses)
      .attribute("complete", &GraphMatch::complete);
  module.def("match_graphs", &match_graphs<double>, py::arg("candidate"), py::arg("query"),
             py::arg_v("options", MatchOptions(), "MatchOptions()"),
             py::call_guard<py::gil_scoped_release>(), doc("match_graphs"));
  module.def("scaled", &scaled<double>, py::arg("graph"), py::arg("factor"), doc("scaled"));
  py::class_<RigidFit> fit(module, "RigidFit", doc("RigidFit"));
  Attributes(fit, "RigidFit")
      .attribute("T_target_source", &RigidFit::T_target_source)
      .attribute("rms", &RigidFit::rms)
      .attribute("spread", &RigidFit::spread);
  module.def("fit_rigid", &fitted, py::arg("target"), py::arg("source"),
             py::arg("weights") = py::none(),
             "The rigid motion that carries `source` (n x 3, m) onto `target` with the least "
             "weighted squares (Umeyama, PAMI 1991, without scale); None without a point.");
}

}  // namespace python
