// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include <topobag/graph/topology_graph.hpp>
#include <topobag/matching/class_groups.hpp>
#include <topobag/matching/coincident_objects.hpp>
#include <topobag/matching/relative_pose.hpp>

namespace topobag {
inline namespace v0 {

/// What became of an object.
enum class ChangeKind {
  moved,     ///< gone from where it was, and one of its class stands elsewhere
  appeared,  ///< stands where the candidate's cameras saw nothing
  gone,      ///< the query's cameras see nothing where it stood
};

/// In a word, for a log.
inline const char* to_string(ChangeKind kind) noexcept {
  switch (kind) {
    case ChangeKind::moved:
      return "moved";
    case ChangeKind::appeared:
      return "appeared";
    case ChangeKind::gone:
      return "gone";
  }
  return "";
}

/// An object that is not where it was.
struct ObjectChange {
  ChangeKind kind = ChangeKind::gone;     ///< what happened
  ClassId label{};                        ///< class of the object
  std::optional<NodeIndex> candidate;     ///< the object as it was
  std::optional<NodeIndex> query;         ///< the object as it is
  std::optional<Eigen::Vector3d> before;  ///< where it was, in the candidate's frame, m
  std::optional<Eigen::Vector3d> after;   ///< where it is, in the candidate's frame, m
};

/// When an object is the same one, and when it has moved.
struct ChangeOptions {
  ClassGroups classes{};           ///< as for the matching
  CoincidenceOptions unchanged{};  ///< when an object is where it was
  double max_move = 3.0;           ///< m; further away it is another object
};

/// What changed between a place's graph and the query's, by a pose that was verified: objects that
/// moved (the nearest of one class first), then appeared, then gone, each by ascending node.
///
/// Only what a camera would have shown counts (`RelativePose::missing`), so graphs without views
/// give nothing. O(n · k log(n · k)).
template <typename Scalar>
std::vector<ObjectChange> what_changed(const TopologyGraph<Scalar>& candidate,
                                       const TopologyGraph<Scalar>& query, const RelativePose& pose,
                                       const ChangeOptions& options = {}) {
  std::vector<bool> settled(query.size(), false);
  std::vector<bool> still_there(candidate.size(), false);
  for (const Correspondence& pair : coincident_objects(candidate, query, pose, options.unchanged)) {
    settled[value(pair.query)] = still_there[value(pair.candidate)] = true;
  }
  const auto place_of = [](const auto& node) -> Eigen::Vector3d {
    return node.position->template cast<double>();
  };
  std::vector<NodeIndex> gone, appeared;
  for (const MissingObject& missing : pose.missing) {
    const bool unchanged =
        missing.of_candidate ? still_there[value(missing.node)] : settled[value(missing.node)];
    if (!unchanged) (missing.of_candidate ? gone : appeared).push_back(missing.node);
  }

  std::vector<std::pair<double, Correspondence>> moves;  // distance, m
  for (const NodeIndex p : gone) {
    for (std::size_t q = 0; q < query.size(); ++q) {
      const auto& here = query.nodes()[q];
      if (settled[q] || !here.position) continue;
      if (!options.classes.compatible(candidate.node(p).label, here.label)) continue;
      const double distance =
          (pose.in_candidate(place_of(here)) - place_of(candidate.node(p))).norm();
      if (distance <= options.max_move) moves.push_back({distance, {p, node_index(q)}});
    }
  }
  std::sort(moves.begin(), moves.end());
  std::vector<ObjectChange> changes;
  for (const auto& [distance, pair] : moves) {
    if (settled[value(pair.query)] || still_there[value(pair.candidate)]) continue;
    settled[value(pair.query)] = still_there[value(pair.candidate)] = true;
    changes.push_back({ChangeKind::moved, query.node(pair.query).label, pair.candidate, pair.query,
                       place_of(candidate.node(pair.candidate)),
                       pose.in_candidate(place_of(query.node(pair.query)))});
  }
  for (const NodeIndex q : appeared) {
    if (settled[value(q)]) continue;
    changes.push_back({ChangeKind::appeared, query.node(q).label, std::nullopt, q, std::nullopt,
                       pose.in_candidate(place_of(query.node(q)))});
  }
  for (const NodeIndex p : gone) {
    if (still_there[value(p)]) continue;
    changes.push_back({ChangeKind::gone, candidate.node(p).label, p, std::nullopt,
                       place_of(candidate.node(p)), std::nullopt});
  }
  return changes;
}

}  // namespace v0
}  // namespace topobag
