// SPDX-License-Identifier: MIT
#include "recognition_run.hpp"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <map>
#include <utility>

#include <topobag/bag/graph_codec.hpp>

#include "input_error.hpp"

namespace program {
namespace {

/// The middle value, or the mean of the middle two.
std::optional<double> median(std::vector<double> values) {
  if (values.empty()) return std::nullopt;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  if (values.size() % 2 == 1) return *middle;
  return (*std::max_element(values.begin(), middle) + *middle) / 2.0;
}

}  // namespace

std::string name_of(const std::string& set) {
  return std::filesystem::path(set).filename().string();
}

void require_queries(const RecognitionRun& run) {
  std::size_t unusable = 0;
  for (const LookUp& look_up : run.look_ups) {
    if (look_up.is_query()) return;
    if (!look_up.recognition.usable) ++unusable;
  }
  const std::size_t all = run.look_ups.size();
  throw InputError(run.query_set,
                   "none of the " + std::to_string(all) +
                       " key frames could be looked up: " + std::to_string(unusable) +
                       " have no usable graph, " + std::to_string(all - unusable) +
                       " nothing to compare with, such as a key frame that is older "
                       "by --min-gap");
}

std::size_t count_in_map(const RecognitionRun& run) {
  std::multimap<double, const Keyframe*> by_time;
  for (const Keyframe& keyframe : run.map) by_time.emplace(keyframe.timestamp, &keyframe);
  const auto is_in_map = [&](const Keyframe& query) {
    const auto [begin, end] = by_time.equal_range(query.timestamp);
    return std::any_of(begin, end, [&](const auto& other) {
      return topobag::encode(other.second->graph) == topobag::encode(query.graph);
    });
  };
  return static_cast<std::size_t>(std::count_if(run.queries.begin(), run.queries.end(), is_in_map));
}

void score(RecognitionRun& run, const Scoring& scoring) {
  for (std::size_t i = 0; i < run.look_ups.size(); ++i) {
    LookUp& look_up = run.look_ups[i];
    const auto& match = look_up.recognition.accepted;
    if (!match) continue;
    if (scoring.different_places) {
      look_up.verdict = topobag::PoseVerdict::wrong;
      continue;
    }
    const auto& T_world_query = run.queries[i].T_world_camera;
    const auto& T_world_candidate = run.map[topobag::value(match->id)].T_world_camera;
    if (!T_world_query || !T_world_candidate) continue;
    look_up.error = topobag::pose_error(T_world_candidate->inverse() * *T_world_query,
                                        match->pose->T_candidate_query);
    look_up.verdict = topobag::judge(*look_up.error, scoring.limits);
  }
}

RunSummary summarize(const RecognitionRun& run) {
  RunSummary summary;
  std::vector<double> translations;
  std::vector<double> rotations;
  std::vector<double> times;
  for (const LookUp& look_up : run.look_ups) {
    if (!look_up.is_query()) continue;
    ++summary.queries;
    times.push_back(look_up.milliseconds);
    if (!look_up.recognition.accepted) continue;
    ++summary.accepted;
    if (look_up.verdict == topobag::PoseVerdict::correct) ++summary.correct;
    if (look_up.verdict == topobag::PoseVerdict::imprecise) ++summary.imprecise;
    if (look_up.verdict == topobag::PoseVerdict::wrong) ++summary.wrong;
    if (!look_up.verdict) ++summary.unscored;
    if (!look_up.error) continue;
    translations.push_back(look_up.error->translation_m);
    rotations.push_back(look_up.error->rotation_deg);
  }
  summary.median_translation_error_m = median(std::move(translations));
  summary.median_rotation_error_deg = median(std::move(rotations));
  summary.median_query_ms = median(std::move(times));
  return summary;
}

}  // namespace program
