// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>

#include <Eigen/Geometry>

#include <topobag/error.hpp>
#include <topobag/types/ids.hpp>
#include <topobag/types/rigid_motion.hpp>

namespace topobag {
inline namespace v0 {

/// Where cameras stand in the world, `T_world_camera` by key frame: what a SLAM back end says anew
/// of all of them when it has closed a loop.
using CameraPoses = std::map<KeyframeId, Eigen::Isometry3d>;

/// Throws InvalidId for a key frame that `bag` does not hold, InvalidValue for a pose that is no
/// rigid motion: what every bag's `set_poses` asks before it changes anything.
/// @param bag     with `contains(KeyframeId) const`
/// @param prefix  of the error: a file's name
template <typename Bag>
void require_poses_of(const Bag& bag, const CameraPoses& poses, const std::string& prefix = {}) {
  for (const auto& [id, T_world_camera] : poses) {
    const std::string key_frame = prefix + "key frame " + std::to_string(value(id));
    if (!bag.contains(id)) {
      throw InvalidId(key_frame + " is not in the bag: only what is there has a pose to set");
    }
    require_rigid(T_world_camera, key_frame + ": the pose");
  }
}

}  // namespace v0
}  // namespace topobag
