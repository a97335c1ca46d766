// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <optional>

#include <Eigen/Geometry>

#include <topobag/error.hpp>
#include <topobag/types/rigid_motion.hpp>

namespace topobag {
inline namespace v0 {

/// How much a view may change before a detector has to look again.
struct StillViewOptions {
  double max_motion = 0.1;   ///< m; a turn of one radian counts as `turn_weight`
  double turn_weight = 1.0;  ///< m a radian
  double max_age = 5.0;      ///< s; what moves by itself is seen no later
};

/// Spares the detector, the dearest part of a semantic front end, where the camera still sees what
/// it saw: tells which key frames it has to look at.
///
///     if (view.should_look(stamp, T_world_camera)) thread.push(job);
///     else database.give_up(epoch, id);  // nobody waits for its objects
///
/// A key frame that is not looked at holds no objects of its own; the one before it stands for the
/// place. One camera, one thread.
class StillView {
 public:
  /// Throws InvalidValue for an option that is negative or not a number.
  explicit StillView(const StillViewOptions& options = {}) : options_(options) {
    for (const double option : {options.max_motion, options.turn_weight, options.max_age}) {
      if (!(option >= 0.0))
        throw InvalidValue("how still a view is must be told by numbers from 0");
    }
  }

  /// Whether to look from here; then it is taken to be done. Also where the clock has gone back.
  /// Throws InvalidValue for a pose that is no rigid motion. O(1).
  /// @param stamp           s
  /// @param T_world_camera  as tracking knows it now; small steps of odometry will do
  template <typename Pose>
  bool should_look(double stamp, const Pose& T_world_camera) {
    require_rigid(T_world_camera, "the pose of the view");
    if (last_ && stamp >= last_->stamp && stamp - last_->stamp <= options_.max_age &&
        motion(last_->T_world_camera, T_world_camera) <= options_.max_motion) {
      return false;
    }
    last_ = Look{stamp, T_world_camera};
    return true;
  }

  /// The next key frame is looked at whatever it sees: the last look came to nothing, or a new map
  /// has begun.
  void forget() noexcept { last_.reset(); }

 private:
  struct Look {
    double stamp;
    Eigen::Isometry3d T_world_camera;
  };

  template <typename Pose>
  double motion(const Pose& T_world_a, const Pose& T_world_b) const {
    const Pose T_a_b = T_world_a.inverse() * T_world_b;
    return T_a_b.translation().norm() +
           options_.turn_weight * Eigen::AngleAxisd(T_a_b.linear()).angle();
  }

  StillViewOptions options_;
  std::optional<Look> last_;
};

}  // namespace v0
}  // namespace topobag
