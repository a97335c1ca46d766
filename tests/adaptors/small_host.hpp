// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <mutex>
#include <optional>
#include <set>

#include <Eigen/Geometry>

#include <topobag/graph/keyframe_sighting.hpp>

#include "recognition/synthetic_room.hpp"

/// The names that the adaptor needs of an ORB-SLAM2, on types of our own.
namespace small_host {

/// A 4 × 4 matrix of floats, read as a cv::Mat is.
struct Pose {
  Eigen::Matrix4f numbers = Eigen::Matrix4f::Identity();

  template <typename T>
  T at(int row, int column) const {
    return numbers(row, column);
  }
};

struct Map {};

class KeyFrame {
 public:
  KeyFrame(unsigned long id, double stamp, const Eigen::Isometry3d& T_world_camera)
      : mnId(id), mTimeStamp(stamp) {
    SetPoseInverse(T_world_camera);
  }

  bool isBad() const { return bad_; }
  void SetBadFlag() { bad_ = true; }

  Pose GetPoseInverse() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return {T_world_camera_.matrix().cast<float>()};
  }
  void SetPoseInverse(const Eigen::Isometry3d& T_world_camera) {
    const std::lock_guard<std::mutex> lock(mutex_);
    T_world_camera_ = T_world_camera;
  }

  std::set<KeyFrame*> GetConnectedKeyFrames() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return connected_;
  }
  void AddConnection(KeyFrame* other) {
    const std::lock_guard<std::mutex> lock(mutex_);
    connected_.insert(other);
  }

  const unsigned long mnId;
  const double mTimeStamp;

 private:
  mutable std::mutex mutex_;
  std::atomic<bool> bad_{false};
  Eigen::Isometry3d T_world_camera_;
  std::set<KeyFrame*> connected_;
};

struct Frame {
  double mTimeStamp = 0.0;
  Eigen::Isometry3d T_world_camera = Eigen::Isometry3d::Identity();
};

/// Which way is down for a key frame of a world whose y axis points down.
inline std::optional<topobag::Gravity<>> gravity_of(const KeyFrame& key_frame) {
  const Eigen::Vector3d down = key_frame.GetPoseInverse().numbers.row(1).head<3>().cast<double>();
  return topobag::Gravity<>{down, 0.02};
}

/// What the room shows from there.
inline topobag::KeyframeSighting sighting(const SyntheticRoom& room, double stamp,
                                          const Eigen::Isometry3d& T_world_camera) {
  topobag::KeyframeSighting seen;
  seen.stamp = stamp;
  seen.nodes = room.seen_from(T_world_camera).nodes();
  return seen;
}

}  // namespace small_host
