// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <topobag/edges/edge_list.hpp>

#include "node_array.hpp"

namespace python {

/// Any of the library's edge builders.
class EdgeBuilder {
 public:
  virtual ~EdgeBuilder() = default;
  virtual topobag::EdgeList operator()(const std::vector<Node>& nodes) const = 0;
};

/// The pairs of an m × 2 array. Throws InvalidValue.
topobag::EdgeList edges_from(const ArrayLike& pairs);

/// An m × 2 array of node indices.
py::array_t<std::uint32_t> pairs_of(const topobag::EdgeList& edges);

/// What a graph is made with: nothing, a builder, a callable that takes nodes and gives an array,
/// or an array. Throws InvalidValue.
topobag::EdgeList resolved_edges(const py::object& edges, const std::vector<Node>& nodes);

}  // namespace python
