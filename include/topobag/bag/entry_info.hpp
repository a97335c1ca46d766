// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include <Eigen/Geometry>

#include <topobag/types/image_descriptor.hpp>
#include <topobag/types/rigid_motion.hpp>
#include <topobag/types/stamp.hpp>
#include <topobag/types/utf8.hpp>

namespace topobag {
inline namespace v0 {

/// What is known of a key frame beside its graph. All of it is optional.
///
/// The poses of a bag are of one world: they are compared with each other, whatever the sessions
/// and labels. Entries of another world come in by `MergeOptions::T_world_other`; where that is not
/// known, without a pose, or moved as a whole to where none of the other worlds is (`HostWorlds`).
struct EntryInfo {
  std::optional<double> stamp;                      ///< s
  std::uint32_t session = 0;                        ///< which run of the robot
  std::optional<Eigen::Isometry3d> T_world_camera;  ///< pose of the camera in the map
  std::string label;                                ///< the user's own: a map, a floor, a robot
  ImageDescriptor image{};  ///< what the whole image looks like, by a method of the user's

  /// Throws InvalidValue for a stamp that is no time in seconds, a pose that is no rigid motion and
  /// a label that is not UTF-8.
  void validate() const {
    if (stamp) require_seconds(*stamp);
    if (T_world_camera) require_rigid(*T_world_camera, "the entry's pose");
    require_utf8(label, "the entry's label");
  }
};

}  // namespace v0
}  // namespace topobag
