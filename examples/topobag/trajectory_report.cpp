// SPDX-License-Identifier: MIT
#include "trajectory_report.hpp"

#include <cmath>
#include <locale>
#include <sstream>

namespace program {

using topobag::AlignmentModel;
using topobag::RelativeStep;

const std::map<std::string, AlignmentModel> alignment_names{
    {"none", AlignmentModel::none}, {"se3", AlignmentModel::se3}, {"sim3", AlignmentModel::sim3}};
const std::map<std::string, RelativeStep::Unit> step_unit_names{
    {"frames", RelativeStep::Unit::frames},
    {"seconds", RelativeStep::Unit::seconds},
    {"metres", RelativeStep::Unit::metres}};

namespace {

Json statistics_json(const std::optional<topobag::ErrorStatistics>& s) {
  if (!s) return nullptr;
  return {{"rmse", s->rmse}, {"mean", s->mean}, {"median", s->median}, {"max", s->max}};
}

std::optional<double> rmse(const std::optional<topobag::ErrorStatistics>& statistics) {
  return statistics ? std::optional<double>(statistics->rmse) : std::nullopt;
}

/// An infinite limit is none.
Json limit_json(double limit) { return std::isfinite(limit) ? Json(limit) : Json(); }

template <typename Value>
std::string name_of(const std::map<std::string, Value>& names, Value value) {
  for (const auto& [name, other] : names) {
    if (other == value) return name;
  }
  return "";
}

}  // namespace

Json score_json(const topobag::SequenceScore& score, const topobag::RelativeStep& step) {
  const auto relative = topobag::relative_pose_errors(score.pairs, step);
  Json json;
  json["poses"] = score.poses;
  json["matched"] = score.errors.size();
  json["correct"] = score.correct_ate_m ? score.correct_ate_m->count : 0;
  json["cr"] = or_null(score.cr);
  json["tracking_cr"] = or_null(score.tracking_cr);
  json["cs_r"] = score.cs_r;
  json["relocalization_time_s"] = or_null(score.relocalization_time_s);
  json["ate_rmse"] = or_null(rmse(score.ate_m));
  json["aoe_rmse"] = or_null(rmse(score.aoe_deg));
  json["correct_ate_rmse"] = or_null(rmse(score.correct_ate_m));
  json["correct_aoe_rmse"] = or_null(rmse(score.correct_aoe_deg));
  json["ate_m"] = statistics_json(score.ate_m);
  json["aoe_deg"] = statistics_json(score.aoe_deg);
  json["rpe_steps"] = relative.size();
  json["rpe_m"] = statistics_json(topobag::translation_statistics(relative));
  json["rpe_deg"] = statistics_json(topobag::rotation_statistics(relative));
  return json;
}

Json rules_json(const topobag::LifelongRules& rules, const topobag::RelativeStep& step,
                bool keep_repeated) {
  Json json;
  json["ate_threshold_m"] = limit_json(rules.ate_threshold_m);
  json["aoe_threshold_deg"] = limit_json(rules.aoe_threshold_deg);
  json["max_pose_interval_s"] = rules.max_pose_interval_s;
  json["tau_s"] = rules.tau_s;
  json["max_gap_s"] = rules.max_gap_s;
  json["interpolation"] =
      rules.interpolation == topobag::RotationInterpolation::slerp ? "slerp" : "openloris";
  json["alignment"] = name_of(alignment_names, rules.alignment);
  json["repeated_poses"] = keep_repeated ? "kept" : "dropped";
  json["rpe_step"] = step.length;
  json["rpe_unit"] = name_of(step_unit_names, step.unit);
  json["rpe_starts"] = step.all_starts ? "every pose" : "end to end";
  return json;
}

std::string errors_csv(const std::map<int, topobag::SequenceScore>& scores) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(17);
  text << "sequence,timestamp,ate_m,aoe_deg\n";
  for (const auto& [number, score] : scores) {
    for (std::size_t i = 0; i < score.errors.size(); ++i) {
      text << number << ',' << score.pairs[i].stamp << ',' << score.errors[i].translation_m << ','
           << score.errors[i].rotation_deg << '\n';
    }
  }
  return text.str();
}

}  // namespace program
