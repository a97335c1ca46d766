// SPDX-License-Identifier: MIT
#include <cmath>
#include <utility>

#include <topobag/graph/topology_graph.hpp>
#include <topobag/sensing/color_descriptor.hpp>

#include "fields.hpp"
#include "node_array.hpp"
#include "rooms.hpp"

namespace python {
namespace {

using topobag::AppearanceKind;
using Optional = std::optional<ArrayLike>;

/// Calls `set(node, row)` for each node, where the column is given.
template <std::size_t Dimensions, typename Set>
void fill(std::vector<Node>& nodes, const Optional& column, const char* name,
          std::initializer_list<py::ssize_t> shape, const Set& set) {
  if (!column) return;
  const py::array_t<double> given = numbers(*column, name, shape);
  require_rows(given, name, static_cast<py::ssize_t>(nodes.size()), "labels");
  const auto entry = given.unchecked<Dimensions>();
  for (std::size_t i = 0; i < nodes.size(); ++i) set(nodes[i], entry, static_cast<py::ssize_t>(i));
}

/// A row of NaN is an absent vector.
template <typename Vector, typename Entry>
std::optional<Vector> vector_at(const Entry& entry, py::ssize_t row) {
  Vector vector;
  for (Eigen::Index i = 0; i < vector.size(); ++i) vector(i) = entry(row, i);
  if (vector.array().isNaN().all()) return std::nullopt;
  return vector;
}

NodeArray nodes_from(const ArrayLike& labels, const Optional& positions, const Optional& pixels,
                     const Optional& z, const Optional& sizes, const Optional& covariances,
                     const Optional& confidences, const Optional& existence,
                     const Optional& appearances, const py::object& appearance_kind,
                     const Optional& weighted_labels, const Optional& label_weights) {
  std::vector<Node> nodes;
  for (const topobag::ClassId label : labels_from(labels)) nodes.emplace_back().label = label;
  fill<2>(nodes, positions, "positions", {any, 3}, [&](Node& node, const auto& entry, auto i) {
    node.position = vector_at<Eigen::Vector3d>(entry, i);
    if (node.position && !z) node.z = std::max(node.position->z(), 0.0);
  });
  fill<2>(nodes, pixels, "pixels", {any, 2}, [](Node& node, const auto& entry, auto i) {
    node.pixel = vector_at<Eigen::Vector2d>(entry, i);
  });
  fill<1>(nodes, z, "z", {any}, [](Node& node, const auto& entry, auto i) { node.z = entry(i); });
  fill<2>(nodes, sizes, "sizes", {any, 2}, [](Node& node, const auto& entry, auto i) {
    node.size = {entry(i, 0), entry(i, 1)};
  });
  fill<3>(nodes, covariances, "covariances", {any, 3, 3}, [](Node& node, const auto& e, auto i) {
    for (int a = 0; a < 3; ++a) {
      for (int b = 0; b < 3; ++b) node.covariance(a, b) = e(i, a, b);
    }
  });
  fill<1>(nodes, confidences, "confidences", {any},
          [](Node& node, const auto& entry, auto i) { node.confidence = entry(i); });
  fill<1>(nodes, existence, "existence", {any},
          [](Node& node, const auto& entry, auto i) { node.existence = entry(i); });
  if (appearances) {
    const auto looks =
        appearances_from(*appearances, appearance_kind, static_cast<py::ssize_t>(nodes.size()));
    for (std::size_t i = 0; i < nodes.size(); ++i) nodes[i].appearance = looks[i];
  }
  const auto weights =
      label_weights_from(weighted_labels, label_weights, static_cast<py::ssize_t>(nodes.size()));
  for (std::size_t i = 0; i < nodes.size(); ++i) nodes[i].label_weights = weights[i];
  // What a graph would refuse is refused here, before an edge builder sees it.
  return {topobag::TopologyGraph<>(std::move(nodes)).nodes()};
}

/// The nodes that NumPy's own indexing picks: a slice, a mask, an array of indices.
NodeArray picked(const NodeArray& array, const py::object& key) {
  const auto all = py::module_::import("numpy").attr("arange")(array.nodes.size());
  const py::object chosen = py::module_::import("numpy").attr("atleast_1d")(all[key]);
  NodeArray result;
  for (const auto i : chosen.cast<std::vector<std::size_t>>()) {
    result.nodes.push_back(array.nodes[i]);
  }
  return result;
}

}  // namespace

void bind_nodes(py::module_& module) {
  py::class_<AppearanceKind>(module, "AppearanceKind", doc("AppearanceKind"))
      .def(py::init<std::string_view, std::size_t>(), py::arg("name"), py::arg("length"),
           doc("DescriptorKind.DescriptorKind"))
      .def_static(
          "color", [] { return topobag::ColorDescriptor::kind; }, "That of color_descriptors.")
      .def(py::pickle(
          [](const AppearanceKind& kind) { return py::make_tuple(kind.number(), kind.length()); },
          [](const py::tuple& state) {
            const auto length = state[1].cast<std::size_t>();
            return length == 0 ? AppearanceKind()
                               : AppearanceKind(state[0].cast<std::uint32_t>(), length);
          }))
      .def_property_readonly("number", &AppearanceKind::number, doc("DescriptorKind.number"))
      .def_property_readonly("length", &AppearanceKind::length, doc("DescriptorKind.length"))
      .def("__eq__", [](const AppearanceKind& a, const AppearanceKind& b) { return a == b; })
      .def("__hash__", [](const AppearanceKind& kind) { return kind.number(); })
      .def("__repr__", [](const AppearanceKind& kind) {
        return "<AppearanceKind " + std::to_string(kind.number()) + " of " +
               std::to_string(kind.length()) + " numbers>";
      });
  py::class_<NodeArray> nodes(
      module, "Nodes",
      "Semantic nodes, the paper's o_i = (u, v, z, c), as columns.\n\n"
      "Frame: the camera of the key frame, x right, y down, z forward, m. "
      "A row of NaN in `positions` or `pixels` is absent; any other number "
      "that is not finite is refused. `z` is that of the positions where it "
      "is left out; a row of zeros in `appearances` is unknown. What an object may be "
      "beside its label stands in `weighted_labels` and `label_weights` (n x k, of any scale, "
      "filled up with weights of 0): the best five stay, its label among the best. The arrays "
      "may have any strides, and are copied.");
  nodes.def(py::init(&nodes_from), py::arg("labels"), py::arg("positions") = py::none(),
            py::kw_only(), py::arg("pixels") = py::none(), py::arg("z") = py::none(),
            py::arg("sizes") = py::none(), py::arg("covariances") = py::none(),
            py::arg("confidences") = py::none(), py::arg("existence") = py::none(),
            py::arg("appearances") = py::none(), py::arg("appearance_kind") = "own",
            py::arg("weighted_labels") = py::none(), py::arg("label_weights") = py::none());
  add_columns(nodes,
              [](const NodeArray& array) -> const std::vector<Node>& { return array.nodes; });
  nodes.def("__len__", [](const NodeArray& array) { return array.nodes.size(); })
      .def("__getitem__", &picked, py::arg("key"), "The nodes of a slice, a mask or indices.")
      .def("__repr__", [](const NodeArray& array) {
        return "<Nodes: " + std::to_string(array.nodes.size()) + ">";
      });
}

}  // namespace python
