// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <utility>
#include <vector>

#include <topobag/error.hpp>
#include <topobag/graph/topology_graph.hpp>
#include <topobag/graph/view.hpp>
#include <topobag/types/semantic_node.hpp>

namespace topobag {
inline namespace v0 {

/// The same graph in another unit of length: positions, depths and sizes times `factor`,
/// covariances times its square, the views' cameras and what hides in them likewise. What is no
/// length stays: pixels, classes, looks, the vertical.
///
/// A graph of a front end without scale, 1 unit of which is `factor` m, is in metres by this.
/// Throws InvalidValue for a factor that is not positive and finite. O(n + m log m + occluders).
template <typename Scalar>
TopologyGraph<Scalar> scaled(const TopologyGraph<Scalar>& graph, double factor) {
  if (!(factor > 0.0 && std::isfinite(factor))) {
    throw InvalidValue("a graph is scaled by a positive number");
  }
  const auto by = static_cast<Scalar>(factor);
  std::vector<SemanticNode<Scalar>> nodes = graph.nodes();
  for (auto& node : nodes) {
    node.z *= by;
    if (node.position) *node.position *= by;
    node.covariance *= by * by;
    node.size *= by;
  }
  std::vector<View<Scalar>> views = graph.views();
  for (auto& view : views) {
    view.T_graph_camera.translation() *= by;
    for (Occluder& occluder : view.occluders) occluder.z *= factor;
    if (view.depth) view.depth = view.depth->scaled(factor);
  }
  return TopologyGraph<Scalar>(std::move(nodes), graph.edges(), std::move(views), graph.gravity());
}

}  // namespace v0
}  // namespace topobag
