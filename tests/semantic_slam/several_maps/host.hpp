// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <mutex>
#include <set>

#include <SemanticHooks.h>

#include "adaptors/small_host.hpp"
#include "semantic_slam/small_frame.hpp"
#include "semantic_slam/small_map_point.hpp"

/// What the program needs of an ORB-SLAM3, on types of our own: key frames lead to one of several
/// maps.
namespace host {

using Frame = SmallFrame;

struct Map {
  std::mutex mMutexMapUpdate;

  bool IsBad() const { return false; }
};

using MapPoint = SmallMapPoint<Eigen::Vector3f>;

inline Eigen::Vector3f position(const Eigen::Vector3d& point) { return point.cast<float>(); }

class KeyFrame : public small_host::KeyFrame, public SmallObservations<MapPoint> {
 public:
  KeyFrame(unsigned long id, double stamp, const Eigen::Isometry3d& T_world_camera, Map& map)
      : small_host::KeyFrame(id, stamp, T_world_camera), map_(&map) {}

  std::set<KeyFrame*> GetConnectedKeyFrames() const { return {}; }
  Map* GetMap() const { return map_; }
  void move_to(Map& map) { map_ = &map; }
  bool is_in(const Map& map) const { return map_ == &map; }

 private:
  std::atomic<Map*> map_;
};

template <typename Hooks>
void give_up(Hooks& hooks, Map& map) {
  hooks.ClearedMap(&map);
}

}  // namespace host

#include "semantic_slam/small_system.hpp"  // in terms of the types above
