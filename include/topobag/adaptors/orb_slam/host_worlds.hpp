// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <map>

#include <Eigen/Geometry>

#include <topobag/types/detail/one_alignment.hpp>

namespace topobag {
inline namespace v0 {

/// Where a camera stands in one of a host's maps.
struct HostCamera {
  const void* map = nullptr;  ///< null for hosts with one alone
  Eigen::Isometry3d T_map_camera = Eigen::Isometry3d::Identity();  ///< in the map's own unit
};

/// One world that holds all maps of a host, each out of the others' reach.
///
/// A bag's poses are of one world, and are compared with each other. How two maps of a host lie to
/// each other nobody knows before they are merged, and both begin about the same numbers: here
/// every map gets a stretch of its own, so that no camera of one is near any of another. Turns and
/// what lies between two cameras of one map are as the host says, to some 1e-8 m for each map
/// before it.
class HostWorlds {
 public:
  /// In the map's unit, m where it has one: more than the Earth is wide, for maps in its frame.
  static constexpr double distance = 1e8;

  /// The camera's pose in that world. The first map that is asked for stays where it is; each that
  /// follows stands further along x. O(log maps).
  Eigen::Isometry3d T_world_camera(const HostCamera& camera) {
    const auto number =
        static_cast<double>(numbers_.emplace(camera.map, numbers_.size()).first->second);
    Eigen::Isometry3d T = camera.T_map_camera;
    T.translation().x() += distance * number;
    return T;
  }

  /// Forgets all maps.
  void clear() noexcept { numbers_.clear(); }

 private:
  std::map<const void*, std::size_t> numbers_;  ///< in the order in which they came
};

}  // namespace v0
}  // namespace topobag
