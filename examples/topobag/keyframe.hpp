// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include <Eigen/Geometry>

#include <topobag/graph/topology_graph.hpp>

namespace program {

/// One run of the robot in a map.
struct SavedSession {
  std::uint32_t id = 0;
  std::string name;  ///< empty where the file keeps none
};

/// What a key frame is in a saved map.
struct SavedEntry {
  std::uint64_t id = 0;  ///< of the map's, over all sessions
  SavedSession session;
};

/// A key frame and its graph, which knows nothing of where in the world it is, but for which way is
/// down where the frame knows.
struct Keyframe {
  std::int64_t idx = 0;                             ///< number of the frame in its table
  double timestamp = 0.0;                           ///< s
  std::optional<Eigen::Isometry3d> T_world_camera;  ///< the truth, for scoring alone
  topobag::TopologyGraph<> graph;
  std::optional<SavedEntry> saved{};  ///< where it comes from a saved map
};

/// As users know it: "idx 30", or "session 1 (Tuesday), idx 30" of a saved map.
inline std::string name_of(const Keyframe& keyframe) {
  std::string name;
  if (keyframe.saved) {
    const SavedSession& session = keyframe.saved->session;
    name = "session " + std::to_string(session.id);
    if (!session.name.empty()) name += " (" + session.name + ")";
    name += ", ";
  }
  return name + "idx " + std::to_string(keyframe.idx);
}

}  // namespace program
