// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include <topobag/edges/edge_list.hpp>
#include <topobag/types/semantic_node.hpp>

namespace topobag {
inline namespace v0 {

/// Joins each node with its k nearest in space; an edge stands when either end chose it.
///
/// Defined for every layout: collinear, coplanar and coincident nodes are nothing special, equal
/// distances go to the smaller index, a node without a position stays isolated. O(n² log k).
struct KnnEdges {
  std::size_t k = 4;  ///< neighbours chosen by each node

  template <typename Scalar>
  EdgeList operator()(const std::vector<SemanticNode<Scalar>>& nodes) const {
    EdgeList edges;
    std::vector<std::pair<Scalar, std::size_t>> others;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      if (!nodes[i].position) continue;
      others.clear();
      for (std::size_t j = 0; j < nodes.size(); ++j) {
        if (j == i || !nodes[j].position) continue;
        others.emplace_back((*nodes[i].position - *nodes[j].position).squaredNorm(), j);
      }
      const auto chosen = static_cast<std::ptrdiff_t>(std::min(k, others.size()));
      std::partial_sort(others.begin(), others.begin() + chosen, others.end());
      for (std::ptrdiff_t n = 0; n < chosen; ++n) {
        edges.push_back(
            make_edge(node_index(i), node_index(others[static_cast<std::size_t>(n)].second)));
      }
    }
    make_canonical(edges);
    return edges;
  }
};

}  // namespace v0
}  // namespace topobag
