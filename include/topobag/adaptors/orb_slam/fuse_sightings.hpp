// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <Eigen/Geometry>

#include <topobag/graph/gravity.hpp>
#include <topobag/graph/keyframe_sighting.hpp>
#include <topobag/graph/local_graph.hpp>

namespace topobag {
inline namespace v0 {

/// A sighting and where the host places its camera.
struct PosedSighting {
  std::shared_ptr<const KeyframeSighting> sighting;  ///< what its key frame shows
  Eigen::Isometry3d T_world_camera =
      Eigen::Isometry3d::Identity();  ///< the host's pose of its key frame
  /// As the host says now; nothing: as the sighting says.
  std::optional<Gravity<>> gravity = std::nullopt;
};

/// The graph of the last sighting's key frame, fused from all of them in the order of time. The
/// world cancels out: only relative poses go in. Sightings and poses have to be in one unit: what
/// was seen is never rescaled, so that a host whose depths come from its own map (monocular ones)
/// and which changes that map's unit leaves the sightings from before in the one of then. Empty for
/// none. Throws as `LocalGraph::add`.
inline TopologyGraph<> fuse_sightings(const std::vector<PosedSighting>& sightings,
                                      const LocalGraphOptions& options) {
  if (sightings.empty()) return {};
  LocalGraph<> local(options);
  const PosedSighting* previous = &sightings.front();
  for (const PosedSighting& current : sightings) {
    local.add(current.sighting->stamp, current.sighting->nodes,
              previous->T_world_camera.inverse() * current.T_world_camera, current.sighting->view,
              current.gravity ? current.gravity : current.sighting->gravity);
    previous = &current;
  }
  return local.graph();
}

}  // namespace v0
}  // namespace topobag
