// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

#include <topobag/graph/topology_graph.hpp>

namespace topobag {
inline namespace v0 {

/// The same objects in a layout that is nowhere: their coordinates along x are permuted among them,
/// and those along z by another permutation. Heights stay, as things of one kind stand equally high
/// everywhere; whole positions would leave too much of the layout as it was. Nodes without a
/// position stay as they are; so do pixels, sizes and covariances. Edges are left out. The same for
/// a seed on every platform. O(n).
template <typename Scalar>
TopologyGraph<Scalar> permuted_layout(const TopologyGraph<Scalar>& graph, std::uint32_t seed) {
  auto nodes = graph.nodes();
  std::vector<std::size_t> placed;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (nodes[i].position) placed.push_back(i);
  }
  std::mt19937 random(seed);
  for (const Eigen::Index axis : {0, 2}) {
    for (std::size_t i = placed.size(); i > 1; --i) {
      const std::size_t j = random() % i;
      std::swap((*nodes[placed[i - 1]].position)(axis), (*nodes[placed[j]].position)(axis));
    }
  }
  return TopologyGraph<Scalar>(std::move(nodes), {}, graph.views());
}

}  // namespace v0
}  // namespace topobag
