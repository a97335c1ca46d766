// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <topobag/assert.hpp>
#include <topobag/error.hpp>
#include <topobag/evaluation/alignment.hpp>
#include <topobag/evaluation/trajectory_error.hpp>

namespace topobag {
inline namespace v0 {

/// The rules of the lifelong SLAM metrics (Shi et al., ICRA 2020).
struct LifelongRules {
  double ate_threshold_m = std::numeric_limits<double>::infinity();    ///< ε of a correct pose, m
  double aoe_threshold_deg = std::numeric_limits<double>::infinity();  ///< φ of a correct pose
  double max_pose_interval_s = 1.0;  ///< Δ_max: how long a correct pose counts, s
  double tau_s = 60.0;               ///< τ of CS-R, s, > 0
  double max_gap_s = 0.5;            ///< to both neighbours for interpolating the truth, s
  RotationInterpolation interpolation = RotationInterpolation::openloris;  ///< of the truth
  AlignmentModel alignment = AlignmentModel::se3;  ///< estimated on the first sequence alone
};

/// The lifelong SLAM metrics of one sequence. Without a matched pose the rates are 0 and the errors
/// undefined.
struct SequenceScore {
  std::size_t poses = 0;                           ///< estimated
  std::vector<PosePair> pairs;                     ///< the matched poses, aligned, by time
  std::vector<PoseError> errors;                   ///< of the pairs
  std::optional<ErrorStatistics> ate_m;            ///< absolute trajectory error
  std::optional<ErrorStatistics> aoe_deg;          ///< absolute orientation error
  std::optional<ErrorStatistics> correct_ate_m;    ///< of the correct poses alone
  std::optional<ErrorStatistics> correct_aoe_deg;  ///< of the correct poses alone
  std::optional<double> cr;  ///< correct rate, CR; undefined when the truth has no duration
  std::optional<double> tracking_cr;            ///< CR from the first matched pose on
  std::optional<double> relocalization_time_s;  ///< first matched pose after the truth's start
  double cs_r = 0.0;  ///< correctness score of re-localization, CS-R: eq. 13 of the paper
};

namespace detail {

/// For how long the sequence was tracked correctly, s: every correct pose counts until the next
/// matched pose, at most Δ_max.
template <typename Pairs>
double correct_time(const Pairs& pairs, const std::vector<bool>& correct, double end_s,
                    double max_pose_interval_s) {
  double sum = 0.0;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const double next = i + 1 < pairs.size() ? pairs[i + 1].stamp : end_s;
    if (correct[i]) sum += std::min(max_pose_interval_s, next - pairs[i].stamp);
  }
  return sum;
}

}  // namespace detail

/// CR, tracking CR, CS-R, ATE and AOE of one sequence against a non-empty ground truth, both in the
/// same world after `alignment`.
/// @param groundtruth,estimate  each a `Trajectory`, or other sorted `StampedPose`, random access
template <typename TruePoses = Trajectory, typename EstimatedPoses = Trajectory>
SequenceScore score_sequence(const TruePoses& groundtruth, const EstimatedPoses& estimate,
                             const Alignment& alignment, const LifelongRules& rules) {
  TOPOBAG_ASSERT(!groundtruth.empty());
  SequenceScore score;
  score.poses = estimate.size();
  score.pairs =
      aligned(associate(groundtruth, estimate, rules.max_gap_s, rules.interpolation), alignment);
  score.errors = pose_errors(score.pairs);

  std::vector<bool> correct;
  std::vector<PoseError> correct_errors;
  for (const PoseError& error : score.errors) {
    correct.push_back(error.translation_m <= rules.ate_threshold_m &&
                      error.rotation_deg <= rules.aoe_threshold_deg);
    if (correct.back()) correct_errors.push_back(error);
  }
  score.ate_m = translation_statistics(score.errors);
  score.aoe_deg = rotation_statistics(score.errors);
  score.correct_ate_m = translation_statistics(correct_errors);
  score.correct_aoe_deg = rotation_statistics(correct_errors);

  const double start_s = groundtruth.front().stamp;
  const double end_s = groundtruth.back().stamp;  // no matched estimate is later
  const double first_s = score.pairs.empty() ? start_s : score.pairs.front().stamp;
  const double tracked_s =
      detail::correct_time(score.pairs, correct, end_s, rules.max_pose_interval_s);
  if (end_s > start_s) score.cr = tracked_s / (end_s - start_s);
  if (end_s > first_s) score.tracking_cr = tracked_s / (end_s - first_s);
  if (score.pairs.empty()) return score;
  score.relocalization_time_s = first_s - start_s;
  if (correct.front()) score.cs_r = std::exp(-*score.relocalization_time_s / rules.tau_s);
  return score;
}

/// Scores of every estimated sequence by number. The alignment is estimated on the lowest-numbered
/// one only and applied to all: a lifelong system has to know where it is in its first map. Without
/// a match there it is the identity. Throws Error when a sequence has no ground truth.
/// @param groundtruth,estimates  each a `std::map<int, Trajectory>`, or what is looked up like one
template <typename TrueSequences = std::map<int, Trajectory>,
          typename EstimatedSequences = std::map<int, Trajectory>>
std::map<int, SequenceScore> score_lifelong(const TrueSequences& groundtruth,
                                            const EstimatedSequences& estimates,
                                            const LifelongRules& rules = {}) {
  for (const auto& [number, estimate] : estimates) {
    const auto truth = groundtruth.find(number);
    if (truth == groundtruth.end() || truth->second.empty()) {
      throw Error("sequence " + std::to_string(number) + " of the estimate has no ground truth.");
    }
  }
  std::map<int, SequenceScore> scores;
  if (estimates.empty()) return scores;
  const auto& [first_number, first] = *estimates.begin();
  const Alignment alignment =
      align(associate(groundtruth.at(first_number), first, rules.max_gap_s, rules.interpolation),
            rules.alignment);
  for (const auto& [number, estimate] : estimates) {
    scores.emplace(number, score_sequence(groundtruth.at(number), estimate, alignment, rules));
  }
  return scores;
}

}  // namespace v0
}  // namespace topobag
