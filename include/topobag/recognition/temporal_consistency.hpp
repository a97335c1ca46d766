// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <utility>

#include <Eigen/Geometry>

#include <topobag/recognition/recognition.hpp>
#include <topobag/sensing/sensor_profile.hpp>
#include <topobag/types/rigid_motion.hpp>

namespace topobag {
inline namespace v0 {

/// How many matches have to agree, how closely.
struct TemporalOptions {
  std::size_t min_matches = 3;  ///< that have to agree one after the other, the present one too
  std::size_t max_missed = 1;   ///< key frames without a match in between
  /// m by which the camera's motion between two matches that agree may differ from the front end's.
  double max_translation = default_sensor.pose_resolution;
  double max_rotation = 0.5235988;  ///< rad by which the camera's turn may differ so; 30°
};

/// Believes a match when the key frames before it were matched alike: an accident does not repeat
/// itself in the way the camera moves. A look-alike layout does, as long as it is in view: against
/// that the score has to guard.
///
/// After the consistent groups of ORB-SLAM2 (Mur-Artal, Tardós 2017) and the islands of
/// DLoopDetector (Gálvez-López, Tardós 2012), which ask for successive candidates that lie close
/// together in the map; here the poses have to agree too, where the front end gives its motion.
class TemporalConsistency {
 public:
  /// Says whether two key frames of the map are of one place: a covisibility graph's neighbours, or
  /// ids close together.
  using SamePlace = std::function<bool(KeyframeId, KeyframeId)>;

  /// @param same_place  asked where the poses cannot be compared; without it only a key frame and
  /// itself are of one place
  explicit TemporalConsistency(const TemporalOptions& options = {}, SamePlace same_place = {})
      : options_(options), same_place_(std::move(same_place)) {}

  /// Takes what was said of the next key frame.
  /// @param recognition         a `Recognition`
  /// @param T_previous_current  the front end's motion from this key frame's camera to the one's
  /// before; ignored for the first
  /// @param T_world_candidate   the matched key frame's pose in the map, where it has one
  /// @return whether there is a match and enough before it agree
  /// Throws InvalidValue for a pose that is no rigid motion; then nothing has changed.
  template <typename Answer = Recognition>
  bool add(const Answer& recognition,
           const std::optional<Eigen::Isometry3d>& T_previous_current = std::nullopt,
           const std::optional<Eigen::Isometry3d>& T_world_candidate = std::nullopt) {
    if (T_previous_current) require_rigid(*T_previous_current, "the relative pose");
    if (T_world_candidate) require_rigid(*T_world_candidate, "the candidate's pose");
    if (last_) {
      T_last_current_ = T_last_current_ && T_previous_current
                            ? std::make_optional(*T_last_current_ * *T_previous_current)
                            : std::nullopt;
    }
    if (!recognition) {
      if (++missed_ > options_.max_missed) reset();
      return false;
    }
    const Match match{recognition.accepted->id, recognition.accepted->pose->T_candidate_query,
                      T_world_candidate};
    matches_ = last_ && agree(*last_, match) ? matches_ + 1 : 1;
    last_ = match;
    T_last_current_ = Eigen::Isometry3d::Identity();
    missed_ = 0;
    return matches_ >= options_.min_matches;
  }

  /// Successive matches that agree, up to the last.
  std::size_t matches() const noexcept { return matches_; }

  /// Forgets what came before: tracking was lost, or another map is used.
  void reset() {
    last_.reset();
    matches_ = missed_ = 0;
  }

 private:
  struct Match {
    KeyframeId id;
    Eigen::Isometry3d T_candidate_query;
    std::optional<Eigen::Isometry3d> T_world_candidate;
  };

  template <typename Matched>
  bool agree(const Matched& before, const Matched& now) const {
    const bool one_frame = before.id == now.id;
    if (T_last_current_ && (one_frame || (before.T_world_candidate && now.T_world_candidate))) {
      const Eigen::Isometry3d T_before_now =
          one_frame ? Eigen::Isometry3d::Identity()
                    : before.T_world_candidate->inverse() * *now.T_world_candidate;
      const Eigen::Isometry3d motion =
          before.T_candidate_query.inverse() * T_before_now * now.T_candidate_query;
      const Eigen::Isometry3d error = T_last_current_->inverse() * motion;
      return error.translation().norm() <= options_.max_translation &&
             Eigen::AngleAxisd(error.linear()).angle() <= options_.max_rotation;
    }
    return one_frame || (same_place_ && same_place_(before.id, now.id));
  }

  TemporalOptions options_;
  SamePlace same_place_;
  std::optional<Match> last_;
  std::optional<Eigen::Isometry3d> T_last_current_;  // nothing when a step is not known
  std::size_t matches_ = 0;
  std::size_t missed_ = 0;
};

}  // namespace v0
}  // namespace topobag
