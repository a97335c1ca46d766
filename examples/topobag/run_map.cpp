// SPDX-License-Identifier: MIT
#include "run_map.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace program {

topobag::EntryInfo info_of(const Keyframe& keyframe) {
  topobag::EntryInfo info;
  info.stamp = keyframe.timestamp;
  info.T_world_camera = keyframe.T_world_camera;
  if (keyframe.saved) info.session = keyframe.saved->session.id;
  return info;
}

topobag::RecognitionOptions options_of(const RecognitionRun& run) {
  topobag::RecognitionOptions options = recognition_options_for(run.classes);
  const bool objects = std::all_of(run.map.begin(), run.map.end(), [](const Keyframe& keyframe) {
    return keyframe.graph.views().empty();
  });
  if (objects) options.matching.viewpoint.share = 0.0;
  options.matching.scale = run.scale;
  if (run.calibrated) {
    options.decision.false_accept_rate = run.calibrated->false_accept_rate;
    options.decision.calibration = run.calibrated->calibration;
  }
  return options;
}

topobag::Relocalizer<> relocalizer_of(const RecognitionRun& run) {
  const std::vector<Keyframe>& map = run.map;
  topobag::Relocalizer<> relocalizer(options_of(run));
  for (std::size_t i = 0; i < map.size(); ++i) {
    if (!map[i].graph.is_matchable()) continue;
    relocalizer.map().add(topobag::KeyframeId{i}, map[i].graph, info_of(map[i]));
  }
  return relocalizer;
}

}  // namespace program
