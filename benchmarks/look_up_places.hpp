// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include <topobag/recognition/loop_detector.hpp>
#include <topobag/recognition/relocalizer.hpp>
#include <topobag/types/class_catalog.hpp>

#include "keyframe_graphs.hpp"
#include "place_run.hpp"
#include "pooled_figures.hpp"
#include "run_map.hpp"

/// By how much less than the default is asked for, so that the best answer which passes every other
/// stage is accepted whatever its score.
inline constexpr double any_score = 1e6;

/// The program's options, but that any score will do; what is asked of candidates still differs by
/// the places that could have given their matches.
inline topobag::RecognitionOptions accept_any_score() {
  topobag::RecognitionOptions options =
      topobag::recognition_options(topobag::ClassCatalog::coco80());
  options.decision.surplus += any_score;
  return options;
}

/// What the answer is worth: its margin over the score that the default would have asked for, and
/// its truth.
inline ScoredQuery scored(const topobag::Recognition& found, PlaceKind kind,
                          const std::vector<program::Keyframe>& map,
                          const program::Keyframe& query) {
  ScoredQuery scored;
  if (!found) return scored;
  scored.margin = found.accepted->margin() - any_score;
  if (kind == PlaceKind::other) return scored;
  const program::Keyframe& candidate = map[topobag::value(found.accepted->id)];
  scored.truth = topobag::judge(
      topobag::pose_error(candidate.T_world_camera->inverse() * *query.T_world_camera,
                          found.accepted->pose->T_candidate_query));
  return scored;
}

/// The key frames' graphs of a table of the run.
inline std::vector<program::Keyframe> keyframes_of(const PlaceRun& run, bool of_map) {
  program::KeyframeOptions options;
  options.camera = of_map ? run.map_camera : run.query_camera;
  options.interval = run.interval;
  options.window = run.window;
  options.min_confidence = run.min_confidence;
  options.gravity.world_up = run.world_up;
  options.stress.stream = of_map ? 0 : 1;  // the gravity's noise is another one
  const std::string& table = of_map ? run.map : run.query;
  auto keyframes = program::read_keyframes(table, options);
  for (const program::Keyframe& keyframe : keyframes) {
    if (!keyframe.T_world_camera) {
      throw program::InputError(table + ".frames.csv", "a frame has no pose to be scored with");
    }
  }
  return keyframes;
}

/// Looks the run's queries up: every `stride`-th key frame of those with enough objects and
/// something to be looked up among.
inline std::vector<ScoredQuery> look_up_places(
    const PlaceRun& run, const topobag::RecognitionOptions& options = accept_any_score()) {
  const auto map = keyframes_of(run, true);
  std::vector<ScoredQuery> queries;
  std::size_t next = 0;
  const auto is_due = [&](const program::Keyframe& query) {
    return query.graph.is_matchable() && next++ % run.stride == 0;
  };
  const auto record = [&](const topobag::Recognition& found, const program::Keyframe& query) {
    if (!found.candidates.empty()) queries.push_back(scored(found, run.kind, map, query));
  };
  if (run.kind == PlaceKind::loops) {
    topobag::LoopDetector<> loops({run.min_gap, options});
    for (std::size_t i = 0; i < map.size(); ++i) {
      if (is_due(map[i])) record(loops.detect(map[i].timestamp, map[i].graph), map[i]);
      if (!map[i].graph.is_matchable()) continue;
      loops.bag().add(topobag::KeyframeId{i}, map[i].graph, info_of(map[i]));
    }
    return queries;
  }
  topobag::Relocalizer<> relocalizer(options);
  for (std::size_t i = 0; i < map.size(); ++i) {
    if (!map[i].graph.is_matchable()) continue;
    relocalizer.map().add(topobag::KeyframeId{i}, map[i].graph, info_of(map[i]));
  }
  for (const program::Keyframe& query : keyframes_of(run, false)) {
    if (is_due(query)) record(relocalizer.localize(query.graph), query);
  }
  return queries;
}
