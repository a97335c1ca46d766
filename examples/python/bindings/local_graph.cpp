// SPDX-License-Identifier: MIT
#include <topobag/graph/keyframe_sighting.hpp>
#include <topobag/graph/local_graph.hpp>
#include <topobag/graph/sight_keyframe.hpp>

#include "detections.hpp"
#include "edges.hpp"
#include "fields.hpp"
#include "rooms.hpp"

namespace python {
namespace {

using LocalGraph = topobag::LocalGraph<>;
using Sighting = topobag::KeyframeSighting;
using Gravity = topobag::Gravity<>;
using View = topobag::View<>;

Sighting sighted(double stamp, const ArrayLike& boxes, const ArrayLike& labels,
                 const std::optional<ArrayLike>& scores, const ArrayLike& z,
                 const topobag::PinholeCamera<>& camera, const topobag::ClassCatalog& catalog,
                 const topobag::SightingOptions& options,
                 const std::optional<ArrayLike>& appearances, const py::object& appearance_kind,
                 const std::optional<ArrayLike>& weighted_labels,
                 const std::optional<ArrayLike>& label_weights) {
  return topobag::sight_keyframe(stamp,
                                 detections_from(boxes, labels, scores, z, appearances,
                                                 appearance_kind, weighted_labels, label_weights),
                                 camera, catalog, options);
}

topobag::TopologyGraph<> fused(const LocalGraph& local, const py::object& edges) {
  if (edges.is_none()) return local.graph();
  return local.graph([&](const std::vector<Node>& nodes) { return resolved_edges(edges, nodes); });
}

py::tuple objects_of(const LocalGraph& local) {
  std::vector<std::uint64_t> ids;
  NodeArray array;
  for (auto& [id, node] : local.objects()) {
    ids.push_back(static_cast<std::uint64_t>(id));
    array.nodes.push_back(std::move(node));
  }
  return py::make_tuple(array_from(ids), array);
}

}  // namespace

void bind_local_graph(py::module_& module) {
  using topobag::SightingOptions;
  Fields<SightingOptions>(module, "SightingOptions")
      .field("lifting", &SightingOptions::lifting)
      .field("max_detections", &SightingOptions::max_detections);
  py::class_<Sighting>(module, "KeyframeSighting", doc("KeyframeSighting"))
      .def_readonly("stamp", &Sighting::stamp, doc("KeyframeSighting.stamp"))
      .def_property_readonly(
          "nodes", [](const Sighting& sighting) { return NodeArray{sighting.nodes}; },
          doc("KeyframeSighting.nodes"))
      .def_readonly("view", &Sighting::view, doc("KeyframeSighting.view"));
  module.def("sight_keyframe", &sighted, py::arg("stamp"), py::arg("boxes"), py::arg("labels"),
             py::arg("scores"), py::arg("z"), py::arg("camera"),
             py::arg_v("catalog", topobag::ClassCatalog::coco80(), "ClassCatalog.coco80()"),
             py::arg_v("options", SightingOptions(), "SightingOptions()"), py::kw_only(),
             py::arg("appearances") = py::none(), py::arg("appearance_kind") = "own",
             py::arg("weighted_labels") = py::none(), py::arg("label_weights") = py::none(),
             doc("sight_keyframe"));
  py::class_<LocalGraph>(module, "LocalGraph", doc("LocalGraph"))
      .def(py::init<topobag::LocalGraphOptions>(),
           py::arg_v("options", topobag::LocalGraphOptions(), "LocalGraphOptions()"))
      .def(
          "add",
          [](LocalGraph& local, double stamp, const NodeArray& array,
             const std::optional<Eigen::Isometry3d>& T_previous_current, const View& view,
             const std::optional<Gravity>& gravity) {
            local.add(stamp, array.nodes,
                      T_previous_current.value_or(Eigen::Isometry3d::Identity()), view, gravity);
          },
          py::arg("stamp"), py::arg("nodes"), py::arg("T_previous_current") = py::none(),
          py::arg_v("view", View(), "View(PinholeCamera())"), py::arg("gravity") = py::none(),
          doc("LocalGraph.add"))
      .def("graph", &fused, py::arg("edges") = py::none(),
           "The fused graph, with the views of its key frames. `edges` as in TopologyGraph, but "
           "KnnEdges where it is left out.")
      .def("objects", &objects_of, "Ids (n), the same while the window slides, and their nodes.")
      .def_property_readonly("gravity", &LocalGraph::gravity, doc("LocalGraph.gravity"))
      .def("__len__", &LocalGraph::view_count, doc("LocalGraph.view_count"))
      .def("__repr__", [](const LocalGraph& local) {
        return "<LocalGraph of " + std::to_string(local.view_count()) + " key frames>";
      });
}

}  // namespace python
