// SPDX-License-Identifier: MIT
#pragma once

#include <topobag/graph/topology_graph.hpp>
#include <topobag/matching/appearance_counts.hpp>
#include <topobag/matching/coincident_objects.hpp>
#include <topobag/matching/relative_pose.hpp>

namespace topobag {
inline namespace v0 {

/// Counts what a verified match says of looks: each two objects of a class that its pose brings
/// together are one. Give it matches that are known to be right. O(n · k log(n · k)).
template <typename Scalar>
void learn_appearance(AppearanceCounts& counts, const TopologyGraph<Scalar>& candidate,
                      const TopologyGraph<Scalar>& query, const RelativePose& pose,
                      const CoincidenceOptions& options = {}) {
  for (const Correspondence& pair : coincident_objects(candidate, query, pose, options)) {
    const auto& p = candidate.node(pair.candidate);
    const auto& q = query.node(pair.query);
    if (p.label == q.label) counts.add_same(p.appearance, q.appearance);
  }
}

/// Counts what two graphs of different places say of looks: each two of their objects that are of a
/// class are two. O(n · k).
template <typename Scalar>
void learn_other_appearance(AppearanceCounts& counts, const TopologyGraph<Scalar>& here,
                            const TopologyGraph<Scalar>& elsewhere) {
  for (const auto& p : here.nodes()) {
    for (const auto& q : elsewhere.nodes()) {
      if (p.label == q.label) counts.add_other(p.appearance, q.appearance);
    }
  }
}

}  // namespace v0
}  // namespace topobag
