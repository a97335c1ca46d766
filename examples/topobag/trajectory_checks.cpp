// SPDX-License-Identifier: MIT
#include "trajectory_checks.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <sstream>
#include <vector>

#include <Eigen/Geometry>

#include <topobag/evaluation/alignment.hpp>
#include <topobag/evaluation/trajectory_error.hpp>

#include "input_error.hpp"
#include "recorded.hpp"
#include "report/html_text.hpp"
#include "trajectory_report.hpp"

namespace program {
namespace {

using Pairs = std::vector<topobag::PosePair>;

/// How far the positions spread about their mean, m: root of the mean square.
double spread(const Pairs& pairs, Eigen::Isometry3d topobag::PosePair::*pose) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const topobag::PosePair& pair : pairs) mean += (pair.*pose).translation();
  mean /= static_cast<double>(pairs.size());
  double sum = 0.0;
  for (const topobag::PosePair& pair : pairs) {
    sum += ((pair.*pose).translation() - mean).squaredNorm();
  }
  return std::sqrt(sum / static_cast<double>(pairs.size()));
}

/// Whether the one is the other but for its size.
bool are_alike(const Pairs& pairs, double true_spread) {
  const auto alignment = topobag::align(pairs, topobag::AlignmentModel::sim3);
  const auto errors = topobag::pose_errors(topobag::aligned(pairs, alignment));
  return topobag::translation_statistics(errors)->rmse < 0.1 * true_spread;
}

std::string unit_name(topobag::RelativeStep::Unit unit) {
  for (const auto& [name, value] : step_unit_names) {
    if (value == unit) return name;
  }
  return "";
}

}  // namespace

void require_whole_frames(const topobag::RelativeStep& step) {
  if (step.unit != topobag::RelativeStep::Unit::frames) return;
  if (std::floor(step.length) == step.length) return;
  throw InputError("--rpe-step " + short_text(step.length),
                   "frames are whole numbers; give one, or --rpe-unit seconds or metres");
}

void require_alignable(const std::string& estimate,
                       const std::map<int, topobag::SequenceScore>& scores) {
  const std::size_t matched = scores.begin()->second.pairs.size();
  if (matched == 0 || matched >= 3) return;
  throw InputError(estimate, matched == 1
                                 ? "one pose alone is matched, which an alignment brings onto the "
                                   "truth wherever it is; give --alignment none"
                                 : "two poses alone are matched, which an alignment brings onto "
                                   "the truth wherever they are, but for their distance; give "
                                   "--alignment none, or three poses at least");
}

std::string score_notes(const std::string& estimate, const topobag::LifelongTrajectories& poses,
                        const std::map<int, topobag::SequenceScore>& scores,
                        const topobag::LifelongRules& rules) {
  std::ostringstream notes;
  std::size_t all = 0, matched = 0;
  for (const auto& [number, score] : scores) {
    all += score.poses;
    matched += score.pairs.size();
  }
  if (2 * matched < all) {
    notes << "topobag: " << estimate << ": " << all - matched << " of " << all
          << " poses have no true poses around them within --max-gap " << rules.max_gap_s
          << " s, and are not scored\n";
  }
  notes.precision(3);
  for (const auto& [number, sequence] : poses.sequences) {
    const auto step =
        topobag::middle_step(sequence, [](const topobag::StampedPose& pose) { return pose.stamp; });
    const std::string question = step ? milliseconds_question(*step) : "";
    if (question.empty() || *step <= rules.max_pose_interval_s) continue;
    notes << "topobag: " << estimate << ": poses are " << *step
          << " s apart in the median, and one counts for --max-pose-interval "
          << rules.max_pose_interval_s << " s" << question << '\n';
  }
  return notes.str();
}

void require_steps(const topobag::RelativeStep& step,
                   const std::map<int, topobag::SequenceScore>& scores) {
  std::size_t most = 0;
  for (const auto& [number, score] : scores) {
    if (!topobag::relative_pose_errors(score.pairs, step).empty()) return;
    most = std::max(most, score.pairs.size());
  }
  throw InputError("--rpe-step " + short_text(step.length),
                   "no two of the " + std::to_string(most) + " matched poses are " +
                       short_text(step.length) + ' ' + unit_name(step.unit) + " apart");
}

void require_one_unit(const std::string& groundtruth, const std::string& estimate,
                      const std::map<int, topobag::SequenceScore>& scores) {
  for (const auto& [number, score] : scores) {
    if (score.pairs.size() < 3) continue;  // any three lie alike or not; two always do
    const double truth = spread(score.pairs, &topobag::PosePair::T_true);
    const double ratio = spread(score.pairs, &topobag::PosePair::T_estimate) / truth;
    const double times = ratio < 1.0 ? 1.0 / ratio : ratio;
    if (!(times > 950.0 && times < 1050.0) || !are_alike(score.pairs, truth)) continue;
    throw InputError(ratio < 1.0 ? groundtruth : estimate,
                     "its trajectory is " + std::to_string(std::lround(times)) +
                         " times as large as that of the other file: is it in millimetres? Both "
                         "are read in metres; --alignment sim3 scores an estimate of another unit");
  }
}

}  // namespace program
