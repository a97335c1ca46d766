// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <string>

#include <topobag/bag/detail/codec/node_layout.hpp>
#include <topobag/error.hpp>
#include <topobag/graph/topology_graph.hpp>

namespace topobag {
inline namespace v0 {

/// Whether the cameras that looked for the nodes come along: they carry the negative evidence, and
/// most of the bytes. A map that is saved without them decides otherwise when it is loaded than
/// before: what is missing speaks against nothing any more.
enum class ViewSection { kept, left_out };

namespace detail {

template <typename Graph>
inline constexpr bool is_topology_graph_v = false;
template <typename Scalar>
inline constexpr bool is_topology_graph_v<TopologyGraph<Scalar>> = true;

template <typename Scalar>
bool is_savable(const SemanticNode<Scalar>& node) {
  return std::abs(static_cast<double>(node.z)) <= max_metres &&
         (!node.position ||
          static_cast<double>(node.position->cwiseAbs().maxCoeff()) <= max_metres);
}

template <typename Scalar>
bool is_savable(const View<Scalar>& view) {
  const Eigen::Vector3d t = view.T_graph_camera.translation().template cast<double>();
  return t.cwiseAbs().maxCoeff() <= max_metres;
}

}  // namespace detail

/// What every graph is held to that a map takes, in memory as in a file, so that what was added can
/// be saved. Throws InvalidValue for more than 4096 nodes, and with its index for a node or a view
/// that is more than 2^20 m away. O(n + views).
template <typename Scalar>
void require_savable(const TopologyGraph<Scalar>& graph, ViewSection views = ViewSection::kept) {
  if (graph.size() > detail::max_nodes) {
    throw InvalidValue("a graph of " + std::to_string(graph.size()) + " nodes; a map keeps up to " +
                       std::to_string(detail::max_nodes));
  }
  for (std::size_t i = 0; i < graph.size(); ++i) {
    if (!detail::is_savable(graph.nodes()[i])) {
      throw InvalidValue(
          "node " + std::to_string(i) + " is more than 2^20 m away: a graph is kept in metres", i);
    }
  }
  for (std::size_t i = 0; views == ViewSection::kept && i < graph.views().size(); ++i) {
    if (!detail::is_savable(graph.views()[i])) {
      throw InvalidValue(
          "view " + std::to_string(i) + " is more than 2^20 m away: a graph is kept in metres", i);
    }
  }
}

}  // namespace v0
}  // namespace topobag
