// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <memory>
#include <mutex>
#include <optional>
#include <random>
#include <set>
#include <vector>

#include <topobag/adaptors/orb_slam.hpp>

#include "adaptors/small_host.hpp"

/// The names that the adaptor needs of an ORB-SLAM3, on types of our own: several maps, each with
/// the lock under which it moves, poses as Sophus has them.
namespace atlas_host {

struct Map {
  bool bad = false;
  std::mutex mMutexMapUpdate;

  bool IsBad() const { return bad; }
};

struct KeyFrame {
  unsigned long mnId;
  double mTimeStamp;
  Eigen::Isometry3d T_world_camera;
  Map* map;
  bool bad = false;

  bool isBad() const { return bad; }
  Map* GetMap() const { return map; }
  Eigen::Isometry3f GetPoseInverse() const {
    return Eigen::Isometry3f(T_world_camera.cast<float>());
  }
  std::set<KeyFrame*> GetConnectedKeyFrames() const { return {}; }
};

struct Frame {
  Eigen::Isometry3d T_world_camera;
};

using Database = topobag::OrbSlamDatabase<KeyFrame, Frame, Map>;
using Pointers = std::vector<KeyFrame*>;

inline topobag::OrbSlamOptions single_frames() {
  topobag::OrbSlamOptions options;
  options.loop_wait = std::chrono::milliseconds(0);
  options.fusing.window = 0.0;
  return options;
}

/// A room, two maps of it, and a database that knows what a lost frame sees.
struct Session {
  explicit Session(unsigned seed, const topobag::OrbSlamOptions& options = single_frames())
      : room(seed, 9, 4), random(seed), database(options, [this](const Frame& frame) {
          return std::optional<topobag::TopologyGraph<>>(room.seen_from(frame.T_world_camera));
        }) {}

  KeyFrame& made(double stamp, Map& map) {
    const auto id = static_cast<unsigned long>(key_frames.size());
    key_frames.push_back(
        std::make_unique<KeyFrame>(KeyFrame{id, stamp, random_camera(random), &map}));
    return *key_frames.back();
  }
  void observe(const KeyFrame& key_frame) {
    database.observe(database.epoch(), key_frame.mnId,
                     small_host::sighting(room, key_frame.mTimeStamp, key_frame.T_world_camera));
  }
  KeyFrame& mapped(double stamp, Map& map) {
    KeyFrame& key_frame = made(stamp, map);
    observe(key_frame);
    database.add(&key_frame);
    return key_frame;
  }

  SyntheticRoom room;
  std::mt19937 random;
  Map first, second;
  std::vector<std::unique_ptr<KeyFrame>> key_frames;
  Database database;
};

}  // namespace atlas_host
