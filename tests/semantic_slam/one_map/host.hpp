// SPDX-License-Identifier: MIT
#pragma once

#include <mutex>
#include <set>

#include <SemanticHooks.h>

#include "adaptors/small_host.hpp"
#include "semantic_slam/small_frame.hpp"
#include "semantic_slam/small_map_point.hpp"

/// What the program needs of an ORB-SLAM2, on types of our own: key frames do not lead to their
/// map.
namespace host {

using Frame = SmallFrame;

struct Map {
  std::mutex mMutexMapUpdate;
};

using MapPoint = SmallMapPoint<cv::Mat>;

inline cv::Mat position(const Eigen::Vector3d& point) {
  const Eigen::Vector3f rounded = point.cast<float>();
  return (cv::Mat_<float>(3, 1) << rounded.x(), rounded.y(), rounded.z());
}

struct KeyFrame : small_host::KeyFrame, SmallObservations<MapPoint> {
  KeyFrame(unsigned long id, double stamp, const Eigen::Isometry3d& T_world_camera, Map&)
      : small_host::KeyFrame(id, stamp, T_world_camera) {}

  std::set<KeyFrame*> GetConnectedKeyFrames() const { return {}; }
  void move_to(Map&) {}
  bool is_in(const Map&) const { return true; }
};

template <typename Hooks>
void give_up(Hooks& hooks, Map&) {
  hooks.Cleared();
}

}  // namespace host

#include "semantic_slam/small_system.hpp"  // in terms of the types above
