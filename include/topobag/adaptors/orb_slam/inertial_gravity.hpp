// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <type_traits>
#include <utility>

#include <Eigen/Geometry>

#include <topobag/adaptors/orb_slam/host_maps.hpp>
#include <topobag/adaptors/orb_slam/host_pose.hpp>
#include <topobag/adaptors/orb_slam/host_traits.hpp>
#include <topobag/graph/gravity.hpp>

namespace topobag {
inline namespace v0 {

namespace detail {

template <typename KeyFrame, typename = void>
struct knows_gravity : std::false_type {};
template <typename KeyFrame>
struct knows_gravity<
    KeyFrame, std::void_t<decltype(std::declval<host_map_t<KeyFrame>&>().isImuInitialized())>>
    : std::true_type {};

}  // namespace detail

/// Which way is down in a key frame's camera frame, as ORB-SLAM3 knows it: once the IMU of a map is
/// initialised, which its `isImuInitialized()` tells, the map's z axis points up. Nothing before,
/// for a camera without an IMU, and for hosts whose maps have no such word.
///
///     OrbSlamDatabase<KeyFrame, Frame, Map> database(options, graph_of_frame,
///                                                    inertial_gravity<KeyFrame>);
///
/// Its deviation is `Gravity`'s default, 1°: the host tells none. Throws as `host_pose`.
template <typename KeyFrame>
std::optional<Gravity<>> inertial_gravity([[maybe_unused]] KeyFrame& key_frame) {
  if constexpr (detail::knows_gravity<KeyFrame>::value) {
    if (host_traits<KeyFrame>::map(key_frame)->isImuInitialized()) {
      const Eigen::Isometry3d T_world_camera =
          host_pose(host_traits<KeyFrame>::T_world_camera(key_frame));
      Gravity<> gravity;
      gravity.down = T_world_camera.linear().transpose() * -Eigen::Vector3d::UnitZ();
      return gravity;
    }
  }
  return std::nullopt;
}

}  // namespace v0
}  // namespace topobag
