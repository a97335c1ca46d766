// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <topobag/graph/bearing.hpp>
#include <topobag/graph/topology_graph.hpp>
#include <topobag/matching/correspondence.hpp>
#include <topobag/matching/relative_pose.hpp>

namespace topobag {
inline namespace v0 {

namespace detail {

/// The bearings as nodes, each as far away as `range_of(i)` says, m; without a position for 0.
template <typename Scalar, typename RangeOf>
TopologyGraph<Scalar> graph_of_bearings(const BearingSighting& sighting, const RangeOf& range_of) {
  std::vector<SemanticNode<Scalar>> nodes;
  for (std::size_t i = 0; i < sighting.bearings.size(); ++i) {
    const Bearing& bearing = sighting.bearings[i];
    SemanticNode<Scalar> node;
    node.label = bearing.label;
    node.confidence = static_cast<Scalar>(bearing.confidence);
    node.appearance = bearing.appearance;
    if (const double range = range_of(i); range > 0.0) {
      const Eigen::Vector3d at = range * bearing.direction;
      node.position = at.cast<Scalar>();
      node.z = static_cast<Scalar>(std::max(0.0, at.z()));
      node.size = (at.z() * bearing.extent).template cast<Scalar>();
    }
    nodes.push_back(std::move(node));
  }
  View<Scalar> view;
  view.T_graph_camera =
      typename View<Scalar>::Pose(sighting.view.T_graph_camera.matrix().template cast<Scalar>());
  view.camera = sighting.view.camera.template cast<Scalar>();
  view.occluders = sighting.view.occluders;
  std::optional<Gravity<Scalar>> gravity;
  if (sighting.gravity) {
    gravity = Gravity<Scalar>{sighting.gravity->down.template cast<Scalar>(),
                              static_cast<Scalar>(sighting.gravity->deviation)};
  }
  return TopologyGraph<Scalar>(std::move(nodes), {}, {std::move(view)}, gravity);
}

}  // namespace detail

/// The bearings as a graph, all of them `range` m away: one to ask a bag's classes by.
template <typename Scalar = double>
TopologyGraph<Scalar> ranged_bearings(const BearingSighting& sighting, double range) {
  return detail::graph_of_bearings<Scalar>(sighting, [&](std::size_t) { return range; });
}

/// The bearings as a graph, with the ranges that a pose gives them: the matched ones lie as far
/// away as their objects, the others have no position. For all that takes a query's graph:
/// `explain`, a map that is to grow by what was seen. O(n + k).
/// @param candidate  whose nodes the pose's inliers name
template <typename Scalar>
TopologyGraph<Scalar> ranged_bearings(const BearingSighting& sighting,
                                      const TopologyGraph<Scalar>& candidate,
                                      const RelativePose& pose) {
  std::vector<double> ranges(sighting.bearings.size(), 0.0);
  const Eigen::Vector3d camera = pose.T_candidate_query.translation();
  for (const Correspondence& pair : pose.inliers) {
    const Eigen::Vector3d at = candidate.node(pair.candidate).position->template cast<double>();
    ranges[value(pair.query)] = (at - camera).norm();
  }
  return detail::graph_of_bearings<Scalar>(sighting, [&](std::size_t i) { return ranges[i]; });
}

}  // namespace v0
}  // namespace topobag
