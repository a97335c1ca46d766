// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <string>

#include <Eigen/Geometry>

#include <topobag/error.hpp>

namespace topobag {
inline namespace v0 {

/// What is known of a key frame beside its graph. All of it is optional.
struct EntryInfo {
  std::optional<double> stamp;                      ///< s
  std::uint32_t session = 0;                        ///< which run of the robot
  std::optional<Eigen::Isometry3d> T_world_camera;  ///< pose of the camera in the map
  std::string label;                                ///< the user's own: a map, a floor, a robot

  /// Throws InvalidValue for a number that is not finite.
  void validate() const {
    if (stamp && !std::isfinite(*stamp)) throw InvalidValue("the entry's stamp is not finite");
    if (T_world_camera && !T_world_camera->matrix().allFinite()) {
      throw InvalidValue("the entry's pose is not finite");
    }
  }
};

}  // namespace v0
}  // namespace topobag
