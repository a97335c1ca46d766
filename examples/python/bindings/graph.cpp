// SPDX-License-Identifier: MIT
#include <topobag/bag/graph_codec.hpp>
#include <topobag/graph/correlation_matrix.hpp>
#include <topobag/graph/topology_graph.hpp>
#include <topobag/graph/topology_weight.hpp>
#include <topobag/graph/vertex_matrix.hpp>

#include <pybind11/eigen.h>

#include "detections.hpp"
#include "edges.hpp"
#include "fields.hpp"
#include "rooms.hpp"

namespace python {
namespace {

using Graph = topobag::TopologyGraph<>;
using Gravity = topobag::Gravity<>;
using View = topobag::View<>;

View view_from(const topobag::PinholeCamera<>& camera, const std::optional<ArrayLike>& boxes,
               const std::optional<ArrayLike>& z, const Eigen::Isometry3d& T_graph_camera) {
  View view;
  view.T_graph_camera = T_graph_camera;
  view.camera = camera;
  if (!boxes) return view;
  for (const auto& box : boxes_from(*boxes, "occluders")) view.occluders.push_back({box, 0.0});
  if (!z) return view;
  const auto given = numbers(*z, "occluder_z", {any});
  require_rows(given, "occluder_z", static_cast<py::ssize_t>(view.occluders.size()), "occluders");
  const auto entry = given.unchecked<1>();
  for (py::ssize_t i = 0; i < given.shape(0); ++i) {
    view.occluders[static_cast<std::size_t>(i)].z = entry(i);
  }
  return view;
}

Graph graph_from(const NodeArray& array, const py::object& edges, std::vector<View> views,
                 const std::optional<Gravity>& gravity) {
  return Graph(array.nodes, resolved_edges(edges, array.nodes), std::move(views), gravity);
}

py::bytes encoded(const Graph& graph) {
  const auto bytes = topobag::encode(graph);
  return py::bytes(reinterpret_cast<const char*>(bytes.data()), bytes.size());
}

Graph decoded(const py::bytes& bytes) {
  const auto text = static_cast<std::string_view>(bytes);
  return topobag::decode(reinterpret_cast<const std::uint8_t*>(text.data()), text.size());
}

void bind_views(py::module_& module) {
  Fields<Gravity>(module, "Gravity")
      .field("down", &Gravity::down)
      .field("deviation", &Gravity::deviation);
  py::class_<View>(module, "View", doc("View"))
      .def(py::init(&view_from), py::arg("camera"), py::arg("occluders") = py::none(),
           py::arg("occluder_z") = py::none(),
           py::arg_v("T_graph_camera", Eigen::Isometry3d(Eigen::Isometry3d::Identity()),
                     "numpy.eye(4)"),
           "`occluders` (n x 4) are boxes x1, y1, x2, y2 of what hides things, px; `occluder_z` "
           "(n) their depths, m, 0 = unknown.")
      .def_readonly("T_graph_camera", &View::T_graph_camera, doc("View.T_graph_camera"))
      .def_readonly("camera", &View::camera, doc("View.camera"))
      .def_property_readonly(
          "occluders",
          [](const View& view) {
            std::vector<topobag::BoundingBox> boxes;
            for (const auto& occluder : view.occluders) boxes.push_back(occluder.box);
            return rows_of_boxes(boxes);
          },
          "Boxes x1, y1, x2, y2 of what hides things, px (n x 4).")
      .def_property_readonly(
          "occluder_z",
          [](const View& view) {
            std::vector<double> z;
            for (const auto& occluder : view.occluders) z.push_back(occluder.z);
            return array_from(z);
          },
          doc("Occluder.z"));
}

}  // namespace

void bind_graph(py::module_& module) {
  bind_views(module);
  py::class_<Graph> graph(module, "TopologyGraph", doc("TopologyGraph"));
  graph.def(py::init(&graph_from), py::arg("nodes"), py::arg("edges") = py::none(),
            py::arg("views") = std::vector<View>{}, py::arg("gravity") = py::none(),
            "`edges`: an edge builder, an m x 2 array of node indices, a callable (nodes) -> such "
            "an array, or None.");
  add_columns(graph, [](const Graph& g) -> const std::vector<Node>& { return g.nodes(); });
  graph
      .def_property_readonly(
          "nodes", [](const Graph& g) { return NodeArray{g.nodes()}; }, doc("TopologyGraph.nodes"))
      .def_property_readonly(
          "edges", [](const Graph& g) { return pairs_of(g.edges()); },
          "Pairs of node indices (m x 2), a < b, ascending, each once.")
      .def_property_readonly(
          "lengths", [](const Graph& g) { return array_from(g.lengths()); },
          doc("TopologyGraph.lengths"))
      .def_property_readonly("views", &Graph::views, doc("TopologyGraph.views"))
      .def_property_readonly("gravity", &Graph::gravity, doc("TopologyGraph.gravity"))
      .def_property_readonly("appearance_kind", &Graph::appearance_kind,
                             doc("TopologyGraph.appearance_kind"))
      .def_property_readonly("is_matchable", &Graph::is_matchable,
                             doc("TopologyGraph.is_matchable"))
      .def_property_readonly(
          "O", [](const Graph& g) { return topobag::vertex_matrix(g); }, doc("vertex_matrix"))
      .def_property_readonly(
          "D", [](const Graph& g) { return topobag::correlation_matrix(g); },
          doc("correlation_matrix"))
      .def_property_readonly(
          "W", [](const Graph& g) { return topobag::topology_weight(g); }, doc("topology_weight"))
      .def("encode", &encoded, doc("encode"))
      .def_static("decode", &decoded, py::arg("bytes"), doc("decode"))
      .def(py::pickle(&encoded, &decoded))
      .def(
          "__array__",
          [](const Graph& g, const py::object& dtype) {
            const py::object O = py::cast(topobag::vertex_matrix(g));
            return dtype.is_none() ? O : py::object(O.attr("astype")(dtype));
          },
          py::arg("dtype") = py::none(), doc("vertex_matrix"))
      .def("__len__", &Graph::size)
      .def("__repr__", [](const Graph& g) {
        return "<TopologyGraph: " + std::to_string(g.size()) + " nodes, " +
               std::to_string(g.edges().size()) + " edges>";
      });
}

}  // namespace python
