// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include <topobag/types/semantic_node.hpp>

#include "arrays.hpp"

namespace python {

using Node = topobag::SemanticNode<>;

/// Nodes as Python has them: one object, whose columns are arrays.
struct NodeArray {
  std::vector<Node> nodes;
};

/// The columns, a row a node; what is absent is NaN.
py::array_t<std::int32_t> labels_of(const std::vector<Node>& nodes);
py::array_t<double> positions_of(const std::vector<Node>& nodes);
py::array_t<double> pixels_of(const std::vector<Node>& nodes);
py::array_t<double> depths_of(const std::vector<Node>& nodes);
py::array_t<double> sizes_of(const std::vector<Node>& nodes);
py::array_t<double> covariances_of(const std::vector<Node>& nodes);
py::array_t<double> confidences_of(const std::vector<Node>& nodes);
py::array_t<double> existences_of(const std::vector<Node>& nodes);
py::array_t<std::int8_t> appearances_of(const std::vector<Node>& nodes);
py::array_t<std::int32_t> weighted_labels_of(const std::vector<Node>& nodes);
py::array_t<double> label_weights_of(const std::vector<Node>& nodes);

/// The appearances of `count` objects from a matrix with a row each, zeros where one is unknown.
/// @param kind  a name, or an `AppearanceKind`
/// Throws InvalidValue.
std::vector<topobag::Appearance> appearances_from(const ArrayLike& rows, const py::object& kind,
                                                  py::ssize_t count);

/// What each of `count` objects may be, from matrices of classes and of what speaks for each, a row
/// an object; a weight of 0 fills a row up. None where neither is given. Throws InvalidValue.
std::vector<topobag::LabelWeights> label_weights_from(const std::optional<ArrayLike>& labels,
                                                      const std::optional<ArrayLike>& weights,
                                                      py::ssize_t count);

/// Numbers as class ids. Throws InvalidValue.
std::vector<topobag::ClassId> labels_from(const ArrayLike& labels);

/// Adds the columns of what `nodes` gives of an object as attributes.
template <typename Class, typename Nodes>
void add_columns(Class& type, const Nodes& nodes) {
  using Object = typename Class::type;
  const auto column = [&](const char* name, auto of, const char* text) {
    type.def_property_readonly(
        name, [nodes, of](const Object& object) { return of(nodes(object)); }, text);
  };
  column("labels", &labels_of, "Class ids (n).");
  column("positions", &positions_of,
         "Places in the camera's frame, m (n x 3); NaN where there is none.");
  column("pixels", &pixels_of, "Box centres u, v, px (n x 2); NaN where there is none.");
  column("z", &depths_of, "Depths, m (n); 0 = unknown.");
  column("sizes", &sizes_of, "Widths and heights, m (n x 2); 0 = unknown.");
  column("covariances", &covariances_of, "Of the positions, m² (n x 3 x 3); 0 = not modelled.");
  column("confidences", &confidences_of, "Detector's scores in [0, 1] (n).");
  column("existence", &existences_of,
         "Shares of the frames that should have shown the objects and did (n).");
  column("appearances", &appearances_of,
         "Descriptors of what the objects look like (n x their length); zeros = unknown.");
  column("weighted_labels", &weighted_labels_of,
         "Classes that the objects may be of, best first (n x k); filled up with -1.");
  column("label_weights", &label_weights_of,
         "What speaks for each of these, in shares of the best one's (n x k); filled up with 0.");
}

}  // namespace python
