// SPDX-License-Identifier: MIT
#pragma once

#include <exception>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include <topobag/adaptors/orb_slam/fuse_sightings.hpp>
#include <topobag/adaptors/orb_slam/fused_window.hpp>
#include <topobag/adaptors/orb_slam/host_maps.hpp>
#include <topobag/adaptors/orb_slam/host_pose.hpp>
#include <topobag/adaptors/orb_slam/key_frame_register.hpp>

namespace topobag {
inline namespace v0 {

/// Which way is down in a key frame's camera frame, by what the host knows now; nothing where it
/// does not know.
template <typename KeyFrame>
using GravityOfHost = std::function<std::optional<Gravity<>>(KeyFrame&)>;

/// What the host says of a key frame at one moment.
struct HostKeyFrameState {
  bool is_readable = false;   ///< its pose is a rigid motion, and asking threw nothing
  bool is_bad = false;        ///< culled
  const void* map = nullptr;  ///< of several; null for hosts with one alone
  Eigen::Isometry3d T_world_camera = Eigen::Isometry3d::Identity();  ///< its pose
  std::optional<Gravity<>> gravity;  ///< nothing: the host does not know

  /// Whether it may be fused into a graph of `own`.
  bool joins(const HostKeyFrameState& own) const { return !is_bad && map == own.map; }
};

/// Asks the host; throws nothing of what goes wrong.
template <typename KeyFrame>
HostKeyFrameState host_state(KeyFrame& key_frame, const GravityOfHost<KeyFrame>& gravity_of) {
  HostKeyFrameState state;
  try {
    state.is_bad = is_bad(key_frame);
    state.map = map_of(key_frame);
    state.T_world_camera = host_pose(host_traits<KeyFrame>::T_world_camera(key_frame));
    if (gravity_of) state.gravity = gravity_of(key_frame);
    state.is_readable = true;
  } catch (const std::exception&) {  // whoever fuses it says why
  }
  return state;
}

/// Reads what a graph of the last one is fused from: those in its map that are not bad, at their
/// poses of now. Throws InvalidValue for a pose that is no rigid motion, and what `gravity_of`
/// throws.
template <typename KeyFrame>
void read_window(const std::vector<SightedKeyFrame<KeyFrame>>& members,
                 const GravityOfHost<KeyFrame>& gravity_of, std::vector<PosedSighting>& posed,
                 FusedWindow& window) {
  KeyFrame& own = *members.back().key_frame;
  const void* const map = map_of(own);
  window = FusedWindow(map);
  for (const SightedKeyFrame<KeyFrame>& member : members) {
    KeyFrame& key_frame = *member.key_frame;
    if (&key_frame != &own && (is_bad(key_frame) || map_of(key_frame) != map)) continue;
    PosedSighting seen{member.sighting,
                       host_pose(host_traits<KeyFrame>::T_world_camera(key_frame))};
    if (gravity_of) seen.gravity = gravity_of(key_frame);
    window.add(member.id, seen.T_world_camera, seen.gravity);
    posed.push_back(std::move(seen));
  }
}

}  // namespace v0
}  // namespace topobag
