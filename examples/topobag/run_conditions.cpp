// SPDX-License-Identifier: MIT
#include "run_conditions.hpp"

#include <algorithm>
#include <cstddef>

#include "report/html_text.hpp"

namespace program {
namespace {

/// Key frames of the map that a query was looked up without, in the mean.
double mean_left_out(const RecognitionRun& run) {
  const std::size_t queries = std::max<std::size_t>(1, run.queries.size());
  return static_cast<double>(run.left_out_of_map) / static_cast<double>(queries);
}

}  // namespace

std::string wrong_text(const RecognitionRun& run) {
  const Scoring& scoring = run.scoring;
  if (scoring.different_places) return "wherever accepted: the sequences share no place";
  std::string text = "beyond " + short_text(scoring.limits.wrong_translation_m) + " m or " +
                     short_text(scoring.limits.wrong_rotation_deg) + "°";
  if (scoring.place_radius) {
    text += ", or of cameras more than " + short_text(*scoring.place_radius) + " m apart (" +
            std::to_string(summarize(run).wrong_by_radius) + " by that alone)";
  }
  return text;
}

std::string left_out_text(const RecognitionRun& run) {
  std::string text;
  if (run.query_interval > 0.0) {
    text = std::to_string(run.before_thinning - run.queries.size()) + " of " +
           std::to_string(run.before_thinning) + " queries, nearer than " +
           short_text(run.query_interval) + " s to the one before";
  }
  if (run.leave_out_radius) {
    text += (text.empty() ? "" : "; ") + fixed_text(mean_left_out(run), 1) + " of the map's " +
            std::to_string(run.map.size()) + " key frames in the mean of the queries, within " +
            short_text(*run.leave_out_radius) + " m of each";
  }
  return text;
}

Json conditions_json(const RecognitionRun& run) {
  Json json = Json::object();
  if (run.scoring.different_places) json["different_places"] = true;
  if (run.scoring.place_radius) {
    json["place_radius_m"] = *run.scoring.place_radius;
    json["wrong_by_radius"] = summarize(run).wrong_by_radius;
  }
  if (run.query_interval > 0.0) {
    json["query_interval_s"] = run.query_interval;
    json["queries_left_out"] = run.before_thinning - run.queries.size();
  }
  if (run.leave_out_radius) {
    json["leave_out_radius_m"] = *run.leave_out_radius;
    json["map_keyframes_left_out"] = mean_left_out(run);
  }
  return json;
}

}  // namespace program
