// SPDX-License-Identifier: MIT
#include <iostream>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <topobag/evaluation/lifelong_score.hpp>
#include <topobag/types/rigid_motion.hpp>

#include "commands.hpp"
#include "csv_reader.hpp"
#include "json_output.hpp"
#include "name_check.hpp"
#include "number_check.hpp"
#include "output_files.hpp"
#include "pose_files.hpp"
#include "report/html_text.hpp"
#include "rotation_reading.hpp"
#include "trajectory_checks.hpp"
#include "trajectory_report.hpp"

namespace program {
namespace {

using topobag::RelativeStep;
using topobag::RotationInterpolation;

struct TrajectoryOptions {
  std::string groundtruth;
  std::string estimate;
  std::string times;
  std::vector<std::string> body_frame;
  std::string interpolation = "auto";
  bool keep_repeated = false;
  bool rpe_consecutive = false;
  bool asks_for_steps = false;  ///< says over which the relative pose error is taken
  bool as_json = false;
  std::string errors;
  topobag::LifelongRules rules;
  RelativeStep step;
};

/// `auto`, or seven numbers separated by blanks or commas.
Eigen::Isometry3d body_frame(const TrajectoryOptions& options, const std::string& frame) {
  if (options.body_frame.empty()) return Eigen::Isometry3d::Identity();
  const InputError no_pose("--body-frame",
                           "give auto, or T_groundtruthbody_estimatebody as seven numbers tx ty tz "
                           "qx qy qz qw with a quaternion of unit length");
  if (options.body_frame.front() == "auto") {
    const auto T_base_frame = topobag::openloris_T_base_frame(frame);
    if (!T_base_frame) {
      throw InputError(options.estimate, "its frame '" + frame +
                                             "' is no sensor of OpenLORIS-Scene; give "
                                             "--body-frame as seven numbers");
    }
    return *T_base_frame;
  }
  std::vector<double> v;
  std::vector<std::string_view> fields;
  for (const std::string& text : options.body_frame) {
    topobag::TextLines::split(text, fields);
    for (const std::string_view field : fields) {
      const std::optional<double> number = parse_number(field);
      if (!number) throw no_pose;
      v.push_back(*number);
    }
  }
  if (v.size() != 7) throw no_pose;
  try {
    return topobag::pose_from_numbers(v);
  } catch (const topobag::InvalidValue&) {
    throw no_pose;
  }
}

/// A pose's number is no time: poses that have none but that go with poses that have one.
void require_one_clock(const TrajectoryOptions& options, const PoseFile& truth,
                       const PoseFile& estimate) {
  if (truth.stamped == estimate.stamped) return;
  throw InputError(truth.stamped ? options.estimate : options.groundtruth,
                   "a KITTI trajectory has no time stamps, the other one has: give --times");
}

/// Whether the times of a sequence's true and estimated poses have some in common.
bool overlap(const PoseFile& truth, const PoseFile& estimate, int number) {
  const auto a = truth.content.sequences.find(number), b = estimate.content.sequences.find(number);
  if (a == truth.content.sequences.end() || b == estimate.content.sequences.end()) return false;
  if (a->second.empty() || b->second.empty()) return false;
  return a->second.front().stamp <= b->second.back().stamp &&
         b->second.front().stamp <= a->second.back().stamp;
}

/// Throws where nothing was scored.
void require_match(const TrajectoryOptions& options, const PoseFile& truth,
                   const PoseFile& estimate, const std::map<int, topobag::SequenceScore>& scores) {
  std::string why = "no sequence is in both";
  for (const auto& [number, score] : scores) {
    if (!score.pairs.empty()) return;
    const auto poses = [&, n = number](const PoseFile& file) {
      const auto found = file.content.sequences.find(n);
      return found == file.content.sequences.end() ? "none" : span_text(found->second);
    };
    why = poses(estimate) + ", the truth has " + poses(truth) +
          (overlap(truth, estimate, number)
               ? "; none of both are within --max-gap " + short_text(options.rules.max_gap_s) + " s"
               : "; are both of one clock?");
  }
  throw InputError(options.estimate, "no pose lies between two true ones of its time: " + why);
}

void score_trajectory(const TrajectoryOptions& options) {
  const auto repeated =
      options.keep_repeated ? topobag::RepeatedPoses::keep : topobag::RepeatedPoses::drop;
  PoseFile truth = read_pose_file(options.groundtruth, options.times);
  const PoseFile estimate = read_pose_file(options.estimate, options.times, repeated);
  if (!options.times.empty() && truth.format != PoseFormat::kitti &&
      estimate.format != PoseFormat::kitti) {
    throw InputError("--times " + options.times, "only KITTI trajectories go with a file of times");
  }
  require_one_clock(options, truth, estimate);
  const Eigen::Isometry3d T_body = body_frame(options, estimate.content.frame);
  for (auto& [number, trajectory] : truth.content.sequences) {
    trajectory = topobag::in_frame(std::move(trajectory), T_body);
  }
  topobag::LifelongRules rules = options.rules;
  const bool benchmark = options.interpolation == "auto" ? estimate.format == PoseFormat::openloris
                                                         : options.interpolation == "openloris";
  rules.interpolation = benchmark ? RotationInterpolation::openloris : RotationInterpolation::slerp;
  const auto scores =
      topobag::score_lifelong(truth.content.sequences, estimate.content.sequences, rules);
  require_match(options, truth, estimate, scores);
  const topobag::AlignmentModel alignment = rules.alignment;
  if (alignment != topobag::AlignmentModel::none) require_alignable(options.estimate, scores);
  if (alignment != topobag::AlignmentModel::sim3) {
    require_one_unit(options.groundtruth, options.estimate, scores);
  }
  if (options.body_frame.empty()) {
    require_same_rotations(options.groundtruth, options.estimate, scores);
  }
  if (options.asks_for_steps) require_steps(options.step, scores);
  if (are_same_file(options.groundtruth, options.estimate)) {
    std::cerr << "topobag: " << options.estimate << ": it is the ground truth itself\n";
  }
  std::cerr << score_notes(options.estimate, estimate.content, scores, rules);

  Json result;
  result["groundtruth"] = options.groundtruth;
  result["estimate"] = options.estimate;
  result["rules"] = rules_json(rules, options.step, options.keep_repeated);
  for (const auto& [number, score] : scores) {
    result["sequences"][std::to_string(number)] = score_json(score, options.step);
  }
  if (!options.errors.empty()) write_file(options.errors, errors_csv(scores));
  std::cout << output_text(result, options.as_json);
}

}  // namespace

void add_trajectory_command(CLI::App& app) {
  CLI::App& command = *app.add_subcommand(
      "trajectory", "Scores a trajectory against the truth: ATE, AOE, RPE, CR, CS-R");
  const auto options = std::make_shared<TrajectoryOptions>();
  topobag::LifelongRules& rules = options->rules;
  const auto positive = number_above_zero();
  command
      .add_option("--groundtruth", options->groundtruth,
                  "True poses: TUM, KITTI, OpenLORIS or SET.frames.csv")
      ->required();
  command.add_option("--estimate", options->estimate, "Estimated poses, in any of the formats")
      ->required();
  command.add_option("--times", options->times, "times.txt of KITTI trajectories");
  command
      .add_option("--body-frame", options->body_frame,
                  "Pose of the estimate's body in the truth's: auto = the OpenLORIS table by the "
                  "file's frame, else tx ty tz qx qy qz qw [the same body]")
      ->expected(1, 7)
      ->delimiter(',');
  command
      .add_option("--ate-threshold", rules.ate_threshold_m,
                  "Largest ATE of a correct pose, m [any]")
      ->check(positive);
  command
      .add_option("--aoe-threshold", rules.aoe_threshold_deg,
                  "Largest AOE of a correct pose, deg [any]")
      ->check(positive);
  command.add_option("--tau", rules.tau_s, "Time constant of CS-R, s")
      ->check(positive)
      ->capture_default_str();
  command
      .add_option("--max-pose-interval", rules.max_pose_interval_s,
                  "For how long a correct pose counts, s")
      ->check(positive)
      ->capture_default_str();
  command.add_option("--max-gap", rules.max_gap_s, "To the true poses interpolated between, s")
      ->check(positive)
      ->capture_default_str();
  command
      .add_option("--alignment", rules.alignment,
                  "Of the first sequence, for all: none, se3 or sim3 [se3]")
      ->transform(one_of(alignment_names));
  command
      .add_option(
          "--interpolation", options->interpolation,
          "Of true rotations: slerp, openloris (as that benchmark's script) or auto (by the "
          "estimate's format)")
      ->check(CLI::IsMember({"auto", "slerp", "openloris"}))
      ->capture_default_str();
  command.add_flag("--keep-repeated", options->keep_repeated,
                   "Keep an OpenLORIS estimate's repeated poses");
  CLI::Option* const length =
      command.add_option("--rpe-step", options->step.length, "Step of the relative pose error")
          ->check(positive)
          ->capture_default_str();
  CLI::Option* const unit =
      command.add_option("--rpe-unit", options->step.unit, "frames, seconds or metres [frames]")
          ->transform(one_of(step_unit_names));
  command.add_flag("--rpe-consecutive", options->rpe_consecutive,
                   "Steps end to end instead of from every pose");
  add_output_option(command, "--errors", options->errors, "CSV to write: the errors of every pose");
  command.add_flag("--json", options->as_json, "Print JSON");
  command.callback([options, length, unit] {
    options->step.all_starts = !options->rpe_consecutive;
    options->asks_for_steps = !length->empty() || !unit->empty();
    require_whole_frames(options->step);
    score_trajectory(*options);
  });
}

}  // namespace program
