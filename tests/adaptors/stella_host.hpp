// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <vector>

#include <Eigen/Core>

#include <topobag/adaptors/orb_slam.hpp>

/// A host of stella_vslam's shape, on types of our own: shared pointers, other names, covisible key
/// frames in a node of a graph, doubles throughout.
namespace stella_host {

struct keyframe;

struct graph_node {
  std::vector<std::weak_ptr<keyframe>> connected_;

  std::vector<std::shared_ptr<keyframe>> get_covisibilities() const {
    std::vector<std::shared_ptr<keyframe>> alive;
    for (const auto& each : connected_) {
      if (auto key_frame = each.lock()) alive.push_back(std::move(key_frame));
    }
    return alive;
  }
};

struct keyframe {
  unsigned int id_;
  double timestamp_;
  Eigen::Matrix4d pose_wc_;
  std::unique_ptr<graph_node> graph_node_ = std::make_unique<graph_node>();
  bool will_be_erased_ = false;

  keyframe(unsigned int id, double timestamp, const Eigen::Isometry3d& T_world_camera)
      : id_(id), timestamp_(timestamp), pose_wc_(T_world_camera.matrix()) {}
  bool will_be_erased() const { return will_be_erased_; }
  Eigen::Matrix4d get_pose_wc() const { return pose_wc_; }
};

struct frame {
  Eigen::Isometry3d T_world_camera;
};

struct map_database {};

}  // namespace stella_host

template <>
struct topobag::host_traits<stella_host::keyframe> {
  using KeyFrame = stella_host::keyframe;
  using Pointer = std::shared_ptr<KeyFrame>;

  static std::uint64_t id(const KeyFrame& key_frame) { return key_frame.id_; }
  static double stamp(const KeyFrame& key_frame) { return key_frame.timestamp_; }
  static bool is_bad(const KeyFrame& key_frame) { return key_frame.will_be_erased(); }
  static Eigen::Matrix4d T_world_camera(const KeyFrame& key_frame) {
    return key_frame.get_pose_wc();
  }
  static std::vector<Pointer> neighbors(const KeyFrame& key_frame) {
    return key_frame.graph_node_->get_covisibilities();
  }
};
