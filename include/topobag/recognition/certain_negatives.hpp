// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

#include <Eigen/Geometry>

#include <topobag/bag/entry_info.hpp>
#include <topobag/recognition/calibration.hpp>
#include <topobag/recognition/decision_options.hpp>
#include <topobag/recognition/place_graph.hpp>
#include <topobag/recognition/recognition.hpp>
#include <topobag/recognition/recognition_options.hpp>
#include <topobag/types/ids.hpp>

namespace topobag {
inline namespace v0 {

/// Options under which a query shows its score whatever it is, to learn from. Looks are judged as
/// before (`appearance_model`).
inline RecognitionOptions without_threshold(RecognitionOptions options) {
  options.matching.chance.appearance = AppearanceModel(appearance_model(options));
  options.decision.calibration.reset();
  options.decision.min_score = -1e6;
  options.place.min_score = -1e6;
  return options;
}

/// What is false where the poses of key frames in the world are known: not a key frame but a pose.
struct PoseNegativeOptions {
  double max_translation = 1.0;     ///< m; a match that puts the query further off is false
  double max_rotation = 0.7853982;  ///< rad; one that turns it by more is false. 45 degrees

  double min_time_gap = 10.0;     ///< s; a key frame is not looked up among those of its session
                                  ///< that are nearer in time
  std::uint64_t min_id_gap = 30;  ///< nearer ids are left out where a stamp is not known

  /// Whether two poses of the query in the world are elsewhere from each other.
  template <typename Pose>
  bool elsewhere(const Pose& T_world_a, const Pose& T_world_b) const {
    const Pose between = T_world_a.inverse() * T_world_b;
    return between.translation().norm() > max_translation ||
           Eigen::AngleAxisd(between.linear()).angle() > max_rotation;
  }

  /// Whether an entry is the key frame itself, or its neighbour in time.
  bool is_neighbor(KeyframeId keyframe, const EntryInfo& info, KeyframeId entry,
                   const EntryInfo& entry_info) const {
    if (entry == keyframe) return true;
    if (info.session != entry_info.session) return false;
    if (info.stamp && entry_info.stamp) {
      return std::abs(*info.stamp - *entry_info.stamp) < min_time_gap;
    }
    const std::uint64_t low = std::min(value(keyframe), value(entry));
    return std::max(value(keyframe), value(entry)) - low < min_id_gap;
  }
};

namespace detail {

/// The entry's pose in the world, where the bag knows it.
template <typename Bag>
std::optional<Eigen::Isometry3d> known_pose(const Bag& bag, KeyframeId id) {
  const auto info = stored_info(bag, id, 0);
  return info ? info->T_world_camera : std::nullopt;
}

/// Whether a candidate's match, which has a pose, puts the query elsewhere than it is.
template <typename Report>
bool is_elsewhere(const Report& report, const Eigen::Isometry3d& T_world_candidate,
                  const Eigen::Isometry3d& T_world_query, const PoseNegativeOptions& options) {
  return options.elsewhere(T_world_query, T_world_candidate * report.pose->T_candidate_query);
}

/// Calls `use` for every match that puts the query elsewhere than it is, was judged by its place
/// and leaves the pose not open.
template <typename Bag, typename Use>
void for_false_matches(const Recognition& recognition, const Bag& bag,
                       const Eigen::Isometry3d& T_world_query, const PoseNegativeOptions& options,
                       Use&& use) {
  for (const CandidateReport& report : recognition.candidates) {
    if (!report.pose || !report.place_support || report.pose->degenerate) continue;
    const auto T_world_candidate = known_pose(bag, report.id);
    if (!T_world_candidate || !is_elsewhere(report, *T_world_candidate, T_world_query, options)) {
      continue;
    }
    use(report);
  }
}

}  // namespace detail

/// The least threshold that would have refused a query of a place that cannot be in the map, made
/// `without_threshold`; nothing when it was refused for another reason.
inline std::optional<double> false_score(const Recognition& recognition) {
  if (!recognition) return std::nullopt;
  return recognition.accepted->score();
}

/// The best score of a match that puts the query elsewhere than it is, among those that were judged
/// by their place and leave the pose not open; nothing when there is none. Entries without a pose
/// in the world are passed over. Throws InvalidValue for a query's pose that is no rigid motion.
/// O(candidates).
/// @param bag  that was asked
template <typename Bag>
std::optional<double> false_score_by_pose(const Recognition& recognition, const Bag& bag,
                                          const Eigen::Isometry3d& T_world_query,
                                          const PoseNegativeOptions& options = {}) {
  require_rigid(T_world_query, "the query's pose");
  std::optional<double> best;
  detail::for_false_matches(recognition, bag, T_world_query, options,
                            [&](const CandidateReport& report) {
                              best = best ? std::max(*best, report.score()) : report.score();
                            });
  return best;
}

/// Whether a decision at its defaults, without calibration, would ask this match for no more: by
/// the places that can hold what was matched, and by whether the query or the candidate has views.
/// Also of a query made `without_threshold`.
inline bool is_beyond_chance(const CandidateReport& report) {
  return report.pose &&
         report.score() >= DecisionOptions{}.threshold(report.places, report.with_views);
}

/// Adds a query of a place that cannot be in the map, made `without_threshold`. One that compared
/// nothing teaches nothing. Whether it was added.
inline bool add_negative(Calibration& calibration, const Recognition& recognition) {
  if (recognition.candidates.empty()) return false;
  calibration.add_negative(false_score(recognition),
                           recognition && is_beyond_chance(*recognition.accepted),
                           recognition.places);
  return true;
}

/// Adds a query whose pose in the world is known, wherever it is: also while mapping, to
/// a calibration that runs.
///
///     const RecognitionOptions open = without_threshold(loops.options());
///     const Recognition all = loops.detect(stamp, graph, session, open);
///     if (add_negative_by_pose(calibration, all, loops.bag(), T_world_camera)) { … }
///
/// Best made `without_threshold`: of a usual query, scores below its threshold may be missing. An
/// entry that was matched where the query is leaves no room for a false match: a query teaches
/// nothing when more than half of its entries with a pose in the world were, or when it compared
/// none. So a map of one place teaches nothing of others. Whether it was added. Throws as
/// `false_score_by_pose`. O(candidates).
/// @param bag  that was asked
template <typename Bag>
bool add_negative_by_pose(Calibration& calibration, const Recognition& recognition, const Bag& bag,
                          const Eigen::Isometry3d& T_world_query,
                          const PoseNegativeOptions& options = {}) {
  require_rigid(T_world_query, "the query's pose");
  std::size_t asked = 0, at_query = 0;
  for (const CandidateReport& report : recognition.candidates) {
    const auto T_world_candidate = detail::known_pose(bag, report.id);
    if (!T_world_candidate) continue;
    ++asked;
    if (!report.pose) continue;
    if (!detail::is_elsewhere(report, *T_world_candidate, T_world_query, options)) ++at_query;
  }
  if (asked == 0 || 2 * at_query > asked) return false;
  bool beyond_chance = false;
  detail::for_false_matches(recognition, bag, T_world_query, options,
                            [&](const CandidateReport& report) {
                              beyond_chance = beyond_chance || is_beyond_chance(report);
                            });
  calibration.add_negative(false_score_by_pose(recognition, bag, T_world_query, options),
                           beyond_chance, recognition.places);
  return true;
}

}  // namespace v0
}  // namespace topobag
