// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <topobag/edges/edge_list.hpp>
#include <topobag/types/semantic_node.hpp>

namespace topobag {
inline namespace v0 {

/// Joins nodes at most `radius` apart in space. A node without a position stays isolated. O(n²).
struct RadiusEdges {
  double radius = 1.0;  ///< m

  template <typename Scalar>
  EdgeList operator()(const std::vector<SemanticNode<Scalar>>& nodes) const {
    EdgeList edges;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      for (std::size_t j = i + 1; j < nodes.size(); ++j) {
        if (!nodes[i].position || !nodes[j].position) continue;
        const auto distance = (*nodes[i].position - *nodes[j].position).norm();
        if (static_cast<double>(distance) <= radius)
          edges.push_back({node_index(i), node_index(j)});
      }
    }
    return edges;
  }
};

}  // namespace v0
}  // namespace topobag
