// SPDX-License-Identifier: MIT
#include "explanation_json.hpp"

#include <array>

#include "keyframe_json.hpp"
#include "pose_numbers.hpp"

namespace program {
namespace {

std::array<double, 3> point_numbers(const Eigen::Vector3d& point) {
  return {point.x(), point.y(), point.z()};
}

Json stage_json(const topobag::ExplainedStage& stage) {
  Json json{{"name", stage.name},
            {"passed", stage.passed},
            {"value", stage.value},
            {stage.at_least ? "at_least" : "at_most", stage.asked}};
  if (!stage.passed) json["missed_by"] = stage.missed_by();
  return json;
}

Json missing_json(const topobag::ExplainedMissing& missing) {
  return {{"class", missing.class_name},
          {"of", missing.of_candidate ? "candidate" : "query"},
          {"position_m", point_numbers(missing.position)},
          {"views", missing.views},
          {"views_with_depth", missing.measured_views},
          {"cost", missing.cost}};
}

Json change_json(const topobag::ExplainedChange& explained) {
  const topobag::ObjectChange& change = explained.change;
  Json json{{"kind", to_string(change.kind)}, {"class", explained.class_name}};
  if (change.before) json["before_m"] = point_numbers(*change.before);
  if (change.after) json["after_m"] = point_numbers(*change.after);
  return json;
}

Json candidate_json(const topobag::CandidateExplanation& candidate,
                    const std::vector<Keyframe>& map) {
  Json json = keyframe_json(map[topobag::value(candidate.id)], "map_");
  json.update(Json{{"verdict", to_string(candidate.verdict)},
                   {"similarity", candidate.similarity},
                   {"confidence", or_null(candidate.confidence)},
                   {"place_support", or_null(candidate.place_support)},
                   {"complete", candidate.complete},
                   {"stages", Json::array()},
                   {"matched", Json::array()},
                   {"missing", Json::array()},
                   {"changes", Json::array()}});
  if (candidate.scale) {
    json["scale"] = candidate.scale->value;
    json["scale_deviation"] = candidate.scale->deviation;
  }
  if (candidate.rival) {
    const topobag::RivalPlace& rival = *candidate.rival;
    json.update(keyframe_json(map[topobag::value(rival.id)], "rival_map_"));
    json["rival_pose_candidate_query"] = pose_numbers(rival.T_candidate_query);
    if (rival.T_world_query) json["rival_pose_world_query"] = pose_numbers(*rival.T_world_query);
  }
  for (const auto& stage : candidate.stages) json["stages"].push_back(stage_json(stage));
  for (const auto& match : candidate.matched) {
    json["matched"].push_back({{"candidate", match.candidate_class},
                               {"query", match.query_class},
                               {"distance_m", match.distance},
                               {"deviations", match.deviations}});
    if (match.looks) json["matched"].back()["looks"] = *match.looks;
  }
  for (const auto& missing : candidate.missing) json["missing"].push_back(missing_json(missing));
  for (const auto& change : candidate.changes) json["changes"].push_back(change_json(change));
  return json;
}

}  // namespace

Json to_json(const topobag::Explanation& explanation, const std::vector<Keyframe>& map) {
  Json json{{"objects", explanation.objects},
            {"usable", explanation.usable},
            {"candidates", Json::array()}};
  for (const auto& candidate : explanation.candidates) {
    json["candidates"].push_back(candidate_json(candidate, map));
  }
  return json;
}

}  // namespace program
