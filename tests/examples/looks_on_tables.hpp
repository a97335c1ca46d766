// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include <topobag/evaluation/pose_error.hpp>
#include <topobag/recognition/relocalizer.hpp>
#include <topobag/types/class_catalog.hpp>

#include "keyframe_graphs.hpp"

/// How the single frames of one table are found in those of another, whose world they share.
struct TableAnswers {
  std::vector<bool> accepted;  ///< of each frame
  std::size_t found = 0;       ///< accepted
  std::size_t correct = 0;     ///< of these, within 0.3 m and 15°
  std::size_t wrong = 0;       ///< beyond 1 m or 45°
};

inline program::KeyframeOptions fr1_single_frames() {
  program::KeyframeOptions options;
  options.camera = {517.3, 516.5, 318.6, 255.3, 640, 480};
  options.interval = options.window = 0.0;
  return options;
}

/// Looks each frame of `query` up in the map of `map`'s, with the program's options.
inline TableAnswers answers_of(const program::NodeTable& map, const program::NodeTable& query) {
  const program::KeyframeOptions frames = fr1_single_frames();
  topobag::Relocalizer<> relocalizer(recognition_options_for(frames.classes));
  const auto there = program::keyframe_graphs(map, frames);
  for (std::size_t i = 0; i < there.size(); ++i) {
    if (!there[i].graph.is_matchable()) continue;
    topobag::EntryInfo info;
    info.stamp = there[i].timestamp;
    info.T_world_camera = there[i].T_world_camera;
    relocalizer.map().add(topobag::KeyframeId{i}, there[i].graph, info);
  }
  TableAnswers answers;
  for (const program::Keyframe& asked : program::keyframe_graphs(query, frames)) {
    const topobag::Recognition found = relocalizer.localize(asked.graph);
    answers.accepted.push_back(static_cast<bool>(found));
    if (!found) continue;
    ++answers.found;
    const auto& candidate = there[topobag::value(found.accepted->id)];
    const Eigen::Isometry3d truth = candidate.T_world_camera->inverse() * *asked.T_world_camera;
    const auto verdict =
        topobag::judge(topobag::pose_error(truth, found.accepted->pose->T_candidate_query), {});
    if (verdict == topobag::PoseVerdict::correct) ++answers.correct;
    if (verdict == topobag::PoseVerdict::wrong) ++answers.wrong;
  }
  return answers;
}
