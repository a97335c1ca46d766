// SPDX-License-Identifier: MIT
#pragma once

#include <topobag/graph/topology_graph.hpp>
#include <topobag/matching/class_confusion.hpp>
#include <topobag/matching/coincident_objects.hpp>
#include <topobag/matching/relative_pose.hpp>

namespace topobag {
inline namespace v0 {

/// Counts what a verified match says of the detector: the labels of every two objects that its pose
/// brings together, also of classes that were never taken for one another. Give it matches that are
/// known to be right: a wrong one teaches confusion. O(n · k log(n · k)).
template <typename Scalar>
void learn_confusion(ClassConfusion& confusion, const TopologyGraph<Scalar>& candidate,
                     const TopologyGraph<Scalar>& query, const RelativePose& pose,
                     const CoincidenceOptions& options = {}) {
  for (const Correspondence& pair : coincident_objects(candidate, query, pose, options)) {
    confusion.add(candidate.node(pair.candidate).label, query.node(pair.query).label);
  }
}

}  // namespace v0
}  // namespace topobag
