// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>

#include <Eigen/Core>

#include <topobag/assert.hpp>
#include <topobag/bag/merge_options.hpp>
#include <topobag/recognition/recognition_options.hpp>
#include <topobag/sensing/sensor_profile.hpp>
#include <topobag/types/pose_with_covariance.hpp>

namespace topobag {
inline namespace v0 {

/// How many key frames have to agree on how two maps lie to each other. Two poses of one camera are
/// the same as for any recognition: `recognition.place`. Where map b's unit is not known, say so in
/// `recognition.matching.scale`: one unit for the whole map.
struct AlignOptions {
  RecognitionOptions recognition{};  ///< how map b's key frames are looked up in map a
  std::size_t max_keyframes = 300;   ///< of map b that are asked, spread evenly over all
  std::size_t min_matches = 3;       ///< key frames that have to agree
  double max_rival_share = 0.5;      ///< of so many, for another alignment, which then fits as well
  /// Of b's key frames that would stand where a's did, looking the same way, so many have to agree.
  /// On the project's sets .21 and more do where the alignment is true, the least where half of the
  /// furniture was moved in between, and up to .05 where it is false.
  double min_revisit_share = 0.125;
  /// σ of a match, by which its alignment may miss another match's camera, and σ of two scales, by
  /// which they may differ.
  double deviations = default_sensor.gate_deviations;
  std::function<void()> on_query{};  ///< when set, called after each, to tell how far it has come
};

/// What became of two maps.
enum class AlignmentVerdict {
  aligned,       ///< one alignment fits
  no_poses,      ///< one of the maps has no key frame with a pose and three objects
  too_few,       ///< not enough key frames agree
  ambiguous,     ///< two alignments fit: the maps repeat themselves
  contradicted,  ///< by the best alignment most key frames would have to be recognised, and are not
};

/// How map b lies in map a: a point of b's world is at T_a_b · (scale · point) in a's.
struct MapAlignment {
  AlignmentVerdict verdict = AlignmentVerdict::no_poses;  ///< whether, and why not
  std::optional<PoseWithCovariance<>> T_a_b;              ///< from b's world to a's, when aligned
  double scale = 1.0;            ///< a's metres in a unit of b, where that was not known
  double scale_deviation = 0.0;  ///< of `scale`, one standard deviation; 0 where it was known
  /// Of the pose's error and that of the scale's logarithm, as `RelativePose::scale_covariance`.
  Eigen::Matrix<double, 6, 1> scale_covariance = Eigen::Matrix<double, 6, 1>::Zero();
  std::size_t asked = 0;       ///< key frames of b
  std::size_t matched = 0;     ///< of them with a verified match
  std::size_t agreeing = 0;    ///< of them for the best alignment
  std::size_t rivalling = 0;   ///< of them for the best other one
  std::size_t places = 0;      ///< of b in which the agreeing stand
  std::size_t revisiting = 0;  ///< asked key frames that by it stand where a's did, looking alike

  /// Whether one alignment fits.
  explicit operator bool() const noexcept { return T_a_b.has_value(); }

  /// How b comes into a, with pose and scale. Precondition: aligned.
  /// @param session_offset  of b's sessions in a
  MergeOptions merge_options(std::uint32_t session_offset = 0) const {
    TOPOBAG_ASSERT(T_a_b);
    MergeOptions options;
    options.session_offset = session_offset;
    options.T_world_other = T_a_b->T;
    options.scale = scale;
    return options;
  }
};

/// In one sentence. A string literal.
constexpr const char* why(AlignmentVerdict verdict) noexcept {
  switch (verdict) {
    case AlignmentVerdict::aligned:
      return "one alignment fits";
    case AlignmentVerdict::no_poses:
      return "a map has no key frame with a pose and three objects: there is nothing to align";
    case AlignmentVerdict::too_few:
      return "too few key frames of one map are recognised in the other, or do not agree";
    case AlignmentVerdict::ambiguous:
      return "two alignments fit: the maps look alike in more than one place";
    case AlignmentVerdict::contradicted:
      return "where the best alignment lays one map over the other, they do not recognise each "
             "other";
  }
  return "";
}

}  // namespace v0
}  // namespace topobag
