// SPDX-License-Identifier: MIT
#include "match_view.hpp"

#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "look_up.hpp"
#include "recognition_report.hpp"
#include "report/html_text.hpp"
#include "view_numbers.hpp"

namespace program {
namespace {

/// "7 objects (2 book, 1 tv)"
template <typename Objects, typename Name>
std::string counted(const Objects& objects, const Name& name_of_object) {
  std::map<std::string, std::size_t> counts;
  for (const auto& object : objects) ++counts[name_of_object(object)];
  std::string text;
  for (const auto& [name, count] : counts) {
    text += (text.empty() ? "" : ", ") + std::to_string(count) + ' ' + name;
  }
  const std::size_t all = objects.size();
  return std::to_string(all) + (all == 1 ? " object (" : " objects (") + text + ")";
}

/// The numbers in one sentence.
std::string sentence(const RecognitionRun& run, std::size_t query,
                     const topobag::CandidateReport& report,
                     const topobag::CandidateExplanation& why) {
  const Keyframe& place = run.map[topobag::value(report.id)];
  std::string text = "Key frame " + name_of(run.queries[query]) + " was taken where " +
                     name_of(place) +
                     " was: " + counted(why.matched, [](const auto& m) { return m.query_class; }) +
                     " lie alike, and the odds that chance made them do so are 1 to 10^" +
                     fixed_text(report.score(), 1) + ", where 1 to 10^" +
                     fixed_text(report.threshold, 1) + " is asked for";
  if (!why.missing.empty()) {
    text += "; " + counted(why.missing, [](const auto& m) { return m.class_name; }) +
            " that should have been seen " + (why.missing.size() == 1 ? "is" : "are") +
            " not there";
  }
  return text + '.';
}

Json stages_json(const topobag::CandidateExplanation& why) {
  Json stages = Json::array();
  for (const topobag::ExplainedStage& stage : why.stages) {
    stages.push_back({{"name", stage.name},
                      {"value", rounded(stage.value)},
                      {stage.at_least ? "at_least" : "at_most", rounded(stage.asked)},
                      {"unit", stage.unit}});
  }
  return stages;
}

Json match_json(const RecognitionRun& run, std::size_t query, std::size_t place,
                const std::vector<std::optional<std::size_t>>& of_nodes) {
  const QueryRecord& record = run.records[query];
  const topobag::CandidateReport& report = *record.recognition.accepted;
  const topobag::CandidateExplanation why = explain_accepted(run, query);
  const Eigen::Isometry3d& T_world_candidate = *run.map[topobag::value(report.id)].T_world_camera;
  const Eigen::Isometry3d T_world_query = T_world_candidate * report.pose->T_candidate_query;
  Json json{{"name", name_of(run.queries[query])},
            {"time", rounded(run.queries[query].timestamp)},
            {"candidate", place},
            {"position", Json::array()},
            {"rotation", Json::array()},
            {"sentence", sentence(run, query, report, why)},
            {"score", rounded(report.score())},
            {"stages", stages_json(why)},
            {"matched", Json::array()},
            {"missing", Json::array()}};
  append(json["position"], T_world_query.translation());
  append(json["rotation"], Eigen::Quaterniond(T_world_query.linear()).coeffs());
  for (const topobag::ExplainedMatch& match : why.matched) {
    json["matched"].push_back({{"object", or_null(of_nodes[topobag::value(match.candidate)])},
                               {"class", match.query_class},
                               {"distance_m", rounded(match.distance)}});
  }
  for (const topobag::ExplainedMissing& missing : why.missing) {
    json["missing"].push_back({{"class", missing.class_name}, {"position", Json::array()}});
    append(json["missing"].back()["position"], T_world_candidate * missing.position);
  }
  if (record.verdict) json["verdict"] = to_string(*record.verdict);
  if (record.error) {
    json["translation_error_m"] = rounded(record.error->translation_m);
    json["rotation_error_deg"] = rounded(record.error->rotation_deg);
  }
  return json;
}

}  // namespace

Json matches_json(const RecognitionRun& run,
                  const std::vector<std::optional<std::size_t>>& number_of,
                  const std::vector<std::vector<std::optional<std::size_t>>>& of_nodes) {
  Json matches = Json::array();
  const bool in_sequence = run.query_set == run.map_set;
  for (std::size_t i = 0; i < run.records.size(); ++i) {
    if (!run.records[i].recognition) continue;
    const auto place = number_of[topobag::value(run.records[i].recognition.accepted->id)];
    if (!place) continue;
    matches.push_back(match_json(run, i, *place, of_nodes[*place]));
    matches.back()["query"] = in_sequence ? or_null(number_of[i]) : Json();
  }
  return matches;
}

}  // namespace program
