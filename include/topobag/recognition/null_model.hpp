// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

#include <topobag/graph/topology_graph.hpp>
#include <topobag/matching/detail/least_turn.hpp>

namespace topobag {
inline namespace v0 {

/// The same objects in a layout that is nowhere: their coordinates along x are permuted among them,
/// and those along z by another permutation; where the graph knows which way is down, those along
/// two horizontal directions. Heights stay, as things of one kind stand equally high everywhere;
/// whole positions would leave too much of the layout as it was. Nodes without a position stay as
/// they are; so do pixels, sizes, covariances and the vertical. Edges are left out. The same for a
/// seed on every platform. O(n).
template <typename Scalar>
TopologyGraph<Scalar> permuted_layout(const TopologyGraph<Scalar>& graph, std::uint32_t seed) {
  auto nodes = graph.nodes();
  std::vector<std::size_t> placed;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (nodes[i].position) placed.push_back(i);
  }
  // From the camera's axes to ones of which y points down.
  const Eigen::Matrix3d level =
      graph.gravity() ? detail::least_turn(graph.gravity()->down.template cast<double>(),
                                           Eigen::Vector3d::UnitY())
                      : Eigen::Matrix3d::Identity();
  const auto turn_all = [&](const Eigen::Matrix<Scalar, 3, 3>& R) {
    for (const std::size_t i : placed) nodes[i].position = (R * *nodes[i].position).eval();
  };
  if (graph.gravity()) turn_all(level.cast<Scalar>());
  std::mt19937 random(seed);
  for (const Eigen::Index axis : {0, 2}) {
    for (std::size_t i = placed.size(); i > 1; --i) {
      const std::size_t j = random() % i;
      std::swap((*nodes[placed[i - 1]].position)(axis), (*nodes[placed[j]].position)(axis));
    }
  }
  if (graph.gravity()) turn_all(level.transpose().cast<Scalar>());
  return TopologyGraph<Scalar>(std::move(nodes), {}, graph.views(), graph.gravity());
}

}  // namespace v0
}  // namespace topobag
