// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Geometry>

#include <topobag/adaptors/orb_slam/host_worlds.hpp>
#include <topobag/graph/gravity.hpp>

namespace topobag {
inline namespace v0 {

/// How far the key frames of a graph may move against each other before it is made anew.
struct StaleTolerance {
  double translation = 0.02;  ///< m
  double rotation = 0.01;     ///< rad; also of what the host says of gravity
};

/// What a graph was fused from: its key frames and where they stood to the last one, which it is
/// of. A world that moves as a whole changes nothing of it.
class FusedWindow {
 public:
  /// Of no key frames yet, of one of the host's maps.
  explicit FusedWindow(const void* map = nullptr) : map_(map) {}

  /// The next key frame, the graph's own at the end.
  void add(std::uint64_t id, const Eigen::Isometry3d& T_world_camera,
           const std::optional<Gravity<>>& gravity) {
    members_.push_back({id, T_world_camera, gravity});
  }

  /// Where the graph's own key frame stood. Precondition: there is one.
  HostCamera camera() const { return {map_, members_.back().T_world_camera}; }

  /// Whether a graph fused from `now` would be another one: key frames came or went, or one stands
  /// elsewhere to the last one by more than the tolerance. O(key frames).
  bool differs_from(const FusedWindow& now, const StaleTolerance& tolerance) const {
    if (members_.size() != now.members_.size()) return true;
    for (std::size_t i = 0; i < members_.size(); ++i) {
      if (members_[i].id != now.members_[i].id) return true;
      const Eigen::Isometry3d moved = to_last(i).inverse() * now.to_last(i);
      if (!(moved.translation().norm() <= tolerance.translation) ||
          !(Eigen::AngleAxisd(moved.linear()).angle() <= tolerance.rotation) ||
          differ(members_[i].gravity, now.members_[i].gravity, tolerance.rotation)) {
        return true;
      }
    }
    return false;
  }

 private:
  struct Member {
    std::uint64_t id;
    Eigen::Isometry3d T_world_camera;
    std::optional<Gravity<>> gravity;
  };

  Eigen::Isometry3d to_last(std::size_t i) const {
    return members_.back().T_world_camera.inverse() * members_[i].T_world_camera;
  }

  static bool differ(const std::optional<Gravity<>>& a, const std::optional<Gravity<>>& b,
                     double tolerance) {
    if (!a || !b) return a.has_value() != b.has_value();
    return !(std::atan2(a->down.cross(b->down).norm(), a->down.dot(b->down)) <= tolerance);
  }

  const void* map_;
  std::vector<Member> members_;
};

}  // namespace v0
}  // namespace topobag
