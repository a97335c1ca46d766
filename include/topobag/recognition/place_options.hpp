// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include <Eigen/Geometry>

#include <topobag/graph/local_graph.hpp>
#include <topobag/sensing/sensor_profile.hpp>

namespace topobag {
inline namespace v0 {

/// How the place around a candidate is looked at, and when two answers are of one place.
struct PlaceOptions {
  std::size_t max_hypotheses = 4;  ///< best poses, each elsewhere, that are judged by their place
  std::size_t max_rivals = 16;     ///< best poses, each elsewhere, that are compared with these
  double min_score = 0.0;          ///< by one graph; below it a pose is not worth the place's time
  /// m; two camera poses in the world further apart, or turned by more, are elsewhere.
  double distinct_translation = default_sensor.place_resolution;
  double distinct_rotation = rotation_resolution;  ///< rad
  std::uint64_t min_id_gap = 30;   ///< without poses, and where no objects tell either: key frames
                                   ///< of one session that are so many apart are elsewhere
  std::size_t max_followed = 400;  ///< without poses: steps from key frame to key frame that are
                                   ///< followed in one query to tell where they stand

  std::size_t max_keyframes = 12;  ///< that are fused with the candidate: the nearest to the query
  /// m around the query's camera, where the world's poses are known.
  double radius = default_sensor.place_radius;
  double turn_weight = 1.0;  ///< m that a turn of one rad counts for, in "nearest" and in `spacing`
  /// m; of key frames of one session that stand and look nearer to each other than this, as in a
  /// map of every image, one is fused: they show the same, errors and all.
  double spacing = 0.1;
  std::size_t max_neighbors = 3;   ///< without poses: key frames before and after the candidate
  double max_contradiction = 4.0;  ///< decades by which a place may speak against its key frame:
                                   ///< one in a thousand is put together wrongly, or has changed
  /// m from an object of the query that its place reaches at least.
  double margin = default_sensor.place_margin;
  double max_depth = default_sensor.detection_range;  ///< m; as far as the query's cameras look
  LocalGraphOptions fusing{};                         ///< its window is not used

  /// Whether two cameras that stand so to each other are at one place, looking the same way.
  bool is_one_place(const Eigen::Isometry3d& T_a_b) const {
    return T_a_b.translation().norm() <= distinct_translation &&
           Eigen::AngleAxisd(T_a_b.linear()).angle() <= distinct_rotation;
  }
};

}  // namespace v0
}  // namespace topobag
