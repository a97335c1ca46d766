// SPDX-License-Identifier: MIT
#include "edges.hpp"

#include <limits>

#include <topobag/edges/complete_edges.hpp>
#include <topobag/edges/delaunay_edges2.hpp>
#include <topobag/edges/delaunay_edges3.hpp>
#include <topobag/edges/gabriel_edges.hpp>
#include <topobag/edges/knn_edges.hpp>
#include <topobag/edges/minimum_spanning_tree_edges.hpp>
#include <topobag/edges/radius_edges.hpp>
#include <topobag/edges/relative_neighborhood_edges.hpp>

#include "fields.hpp"
#include "rooms.hpp"

namespace python {
namespace {

/// One of the library's builders as an `EdgeBuilder`.
template <typename Builder>
class BuilderOf : public EdgeBuilder, public Builder {
 public:
  topobag::EdgeList operator()(const std::vector<Node>& nodes) const override {
    return Builder::operator()(nodes);
  }
};

template <typename Builder>
auto bind_builder(py::module_& module, const char* name) {
  return Fields<BuilderOf<Builder>, EdgeBuilder>(module, name);
}

}  // namespace

topobag::EdgeList edges_from(const ArrayLike& pairs) {
  const auto given = whole_numbers(pairs, "edges", {any, 2});
  const auto entry = given.unchecked<2>();
  topobag::EdgeList edges;
  for (py::ssize_t i = 0; i < given.shape(0); ++i) {
    for (const std::int64_t end : {entry(i, 0), entry(i, 1)}) {
      if (end < 0 || end > std::numeric_limits<std::uint32_t>::max()) {
        throw topobag::InvalidValue("edge " + std::to_string(i) + " joins node " +
                                        std::to_string(end) + ", which there cannot be",
                                    static_cast<std::size_t>(i));
      }
    }
    const auto node = [](std::int64_t end) {
      return topobag::node_index(static_cast<std::size_t>(end));
    };
    edges.push_back({node(entry(i, 0)), node(entry(i, 1))});
  }
  return edges;
}

py::array_t<std::uint32_t> pairs_of(const topobag::EdgeList& edges) {
  py::array_t<std::uint32_t> pairs({static_cast<py::ssize_t>(edges.size()), py::ssize_t{2}});
  std::uint32_t* out = pairs.mutable_data();
  for (const topobag::Edge& edge : edges) {
    *out++ = static_cast<std::uint32_t>(edge.a);
    *out++ = static_cast<std::uint32_t>(edge.b);
  }
  return pairs;
}

topobag::EdgeList resolved_edges(const py::object& edges, const std::vector<Node>& nodes) {
  if (edges.is_none()) return {};
  if (py::isinstance<EdgeBuilder>(edges)) {
    const EdgeBuilder& builder = edges.cast<const EdgeBuilder&>();
    const py::gil_scoped_release unlocked;
    return builder(nodes);
  }
  if (PyCallable_Check(edges.ptr()) != 0) {
    return edges_from(ArrayLike(edges(NodeArray{nodes})));
  }
  return edges_from(ArrayLike(edges));
}

void bind_edges(py::module_& module) {
  py::class_<EdgeBuilder>(module, "EdgeBuilder", "Joins nodes: a callable (nodes) -> m x 2 array.")
      .def(
          "__call__",
          [](const py::object& self, const NodeArray& array) {
            return pairs_of(resolved_edges(self, array.nodes));
          },
          py::arg("nodes"), "The pairs of node indices that it joins (m x 2), a < b, ascending.");
  bind_builder<topobag::CompleteEdges>(module, "CompleteEdges");
  using topobag::KnnEdges;
  bind_builder<KnnEdges>(module, "KnnEdges").field("k", &BuilderOf<KnnEdges>::k);
  using topobag::RadiusEdges;
  bind_builder<RadiusEdges>(module, "RadiusEdges").field("radius", &BuilderOf<RadiusEdges>::radius);
  bind_builder<topobag::DelaunayEdges2<>>(module, "DelaunayEdges2");
  bind_builder<topobag::DelaunayEdges3>(module, "DelaunayEdges3");
  bind_builder<topobag::GabrielEdges<>>(module, "GabrielEdges");
  bind_builder<topobag::RelativeNeighborhoodEdges<>>(module, "RelativeNeighborhoodEdges");
  bind_builder<topobag::MinimumSpanningTreeEdges<>>(module, "MinimumSpanningTreeEdges");
}

}  // namespace python
