// SPDX-License-Identifier: MIT
#include "recognition_run.hpp"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <map>
#include <numeric>
#include <utility>

#include "input_error.hpp"
#include "same_images.hpp"

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

std::optional<QueryTimes> query_times(std::vector<double> ms) {
  if (ms.empty()) return std::nullopt;
  std::sort(ms.begin(), ms.end());
  const std::size_t within_95 = (95 * ms.size() + 99) / 100;
  const double sum = std::accumulate(ms.begin(), ms.end(), 0.0);
  return QueryTimes{*median(ms), sum / static_cast<double>(ms.size()), ms[within_95 - 1],
                    ms.back()};
}

}  // namespace

std::string name_of(const std::string& set) {
  return std::filesystem::path(set).filename().string();
}

void thin_queries(RecognitionRun& run, double interval) {
  run.query_interval = interval;
  run.before_thinning = run.queries.size();
  run.queries = thinned(run.queries, interval);
}

void require_queries(const RecognitionRun& run, const std::string& lacking) {
  std::size_t unusable = 0;
  for (const QueryRecord& record : run.records) {
    if (record.is_query()) return;
    if (!record.recognition.usable) ++unusable;
  }
  const std::size_t all = run.records.size();
  const std::string thinned =
      all < run.before_thinning
          ? ", which --query-interval leaves of " + std::to_string(run.before_thinning) + ','
          : "";
  throw InputError(run.query_set, "none of the " + std::to_string(all) + " key frames" + thinned +
                                      " could be looked up: " + std::to_string(unusable) +
                                      " have no usable graph, " + std::to_string(all - unusable) +
                                      " nothing to compare with, such as " + lacking);
}

std::size_t count_in_map(const RecognitionRun& run) {
  std::multimap<double, const Keyframe*> by_time;
  for (const Keyframe& keyframe : run.map) by_time.emplace(keyframe.timestamp, &keyframe);
  const auto is_in_map = [&](const Keyframe& query) {
    const auto [begin, end] = by_time.equal_range(query.timestamp);
    return std::any_of(begin, end, [&](const auto& other) {
      return are_of_same_images(other.second->graph, other.second->T_world_camera, query.graph,
                                query.T_world_camera);
    });
  };
  return static_cast<std::size_t>(std::count_if(run.queries.begin(), run.queries.end(), is_in_map));
}

void require_poses(const RecognitionRun& run, const std::string& option) {
  const auto require = [&](const std::string& set, const std::vector<Keyframe>& keyframes) {
    for (const Keyframe& keyframe : keyframes) {
      if (keyframe.T_world_camera) continue;
      throw InputError(set, name_of(keyframe) + " has no pose, which " + option +
                                " needs of every key frame; give --trajectory");
    }
  };
  require(run.query_set, run.queries);
  require(run.map_set, run.map);
}

JudgedMatch judge_match(const RecognitionRun& run, std::size_t query,
                        const topobag::CandidateReport& match, const Scoring& scoring) {
  using topobag::PoseVerdict;
  if (scoring.different_places) return {std::nullopt, PoseVerdict::wrong};
  std::optional<Eigen::Isometry3d> T_world_query = run.queries[query].T_world_camera;
  if (T_world_query && run.T_map_query_world) {
    T_world_query = *run.T_map_query_world * *T_world_query;
  }
  const auto& T_world_candidate = run.map[topobag::value(match.id)].T_world_camera;
  if (!T_world_query || !T_world_candidate) return {};
  const Eigen::Isometry3d T_candidate_query = T_world_candidate->inverse() * *T_world_query;
  const topobag::PoseError error =
      topobag::pose_error(T_candidate_query, match.pose->T_candidate_query);
  const bool elsewhere =
      scoring.place_radius && T_candidate_query.translation().norm() > *scoring.place_radius;
  const PoseVerdict by_pose = topobag::judge(error, scoring.limits);
  return {error, elsewhere ? PoseVerdict::wrong : by_pose,
          elsewhere && by_pose != PoseVerdict::wrong};
}

std::optional<Eigen::Isometry3d> aligned_worlds(const RecognitionRun& run,
                                                const topobag::PoseLimits& limits) {
  struct Match {
    Eigen::Isometry3d T_map_camera, T_query_world_camera;
  };
  std::vector<Match> matches;
  for (std::size_t i = 0; i < run.records.size(); ++i) {
    const auto& accepted = run.records[i].recognition.accepted;
    if (!accepted || !run.queries[i].T_world_camera) continue;
    const auto& T_map_candidate = run.map[topobag::value(accepted->id)].T_world_camera;
    if (!T_map_candidate) continue;
    matches.push_back(
        {*T_map_candidate * accepted->pose->T_candidate_query, *run.queries[i].T_world_camera});
  }
  std::optional<Eigen::Isometry3d> best;
  std::ptrdiff_t most = 0;
  for (const Match& match : matches) {
    const Eigen::Isometry3d T = match.T_map_camera * match.T_query_world_camera.inverse();
    const auto correct = std::count_if(matches.begin(), matches.end(), [&](const Match& other) {
      const auto error = topobag::pose_error(T * other.T_query_world_camera, other.T_map_camera);
      return topobag::judge(error, limits) == topobag::PoseVerdict::correct;
    });
    if (correct <= most) continue;
    most = correct;
    best = T;
  }
  return best;
}

void score(RecognitionRun& run, const Scoring& scoring) {
  run.scoring = scoring;
  if (scoring.align_worlds) run.T_map_query_world = aligned_worlds(run, scoring.limits);
  if (scoring.place_radius) require_poses(run, "--place-radius");
  for (std::size_t i = 0; i < run.records.size(); ++i) {
    QueryRecord& record = run.records[i];
    if (!record.recognition) continue;
    const JudgedMatch judged = judge_match(run, i, *record.recognition.accepted, scoring);
    record.error = judged.error;
    record.verdict = judged.verdict;
    record.wrong_by_radius = judged.wrong_by_radius;
  }
}

RunSummary summarize(const RecognitionRun& run) {
  RunSummary summary;
  std::vector<double> translations;
  std::vector<double> rotations;
  std::vector<double> times;
  for (const QueryRecord& record : run.records) {
    if (!record.is_query()) continue;
    ++summary.queries;
    times.push_back(record.milliseconds);
    if (!record.recognition.accepted) continue;
    ++summary.accepted;
    if (record.verdict == topobag::PoseVerdict::correct) ++summary.correct;
    if (record.verdict == topobag::PoseVerdict::imprecise) ++summary.imprecise;
    if (record.verdict == topobag::PoseVerdict::wrong) ++summary.wrong;
    if (record.wrong_by_radius) ++summary.wrong_by_radius;
    if (!record.verdict) ++summary.unscored;
    if (!record.error) continue;
    translations.push_back(record.error->translation_m);
    rotations.push_back(record.error->rotation_deg);
  }
  summary.median_translation_error_m = median(std::move(translations));
  summary.median_rotation_error_deg = median(std::move(rotations));
  summary.query_ms = query_times(std::move(times));
  return summary;
}

}  // namespace program
