// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <topobag/edges/edge_list.hpp>
#include <topobag/types/semantic_node.hpp>

namespace topobag {
inline namespace v0 {

/// An edge builder is any callable `(const std::vector<SemanticNode<Scalar>>&) -> EdgeList`.
/// This one joins every two nodes. O(n²). Use it for small graphs and as the reference of the
/// others.
struct CompleteEdges {
  template <typename Scalar>
  EdgeList operator()(const std::vector<SemanticNode<Scalar>>& nodes) const {
    EdgeList edges;
    if (nodes.size() > 1) edges.reserve(nodes.size() * (nodes.size() - 1) / 2);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      for (std::size_t j = i + 1; j < nodes.size(); ++j) {
        edges.push_back({node_index(i), node_index(j)});
      }
    }
    return edges;
  }
};

}  // namespace v0
}  // namespace topobag
