// SPDX-License-Identifier: MIT
#include "look_up.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>

#include <topobag/recognition/calibrate.hpp>
#include <topobag/recognition/explain.hpp>
#include <topobag/recognition/loop_detector.hpp>
#include <topobag/recognition/relocalizer.hpp>
#include <topobag/types/class_catalog.hpp>

#include "stopwatch.hpp"

namespace program {
namespace {

/// The library's defaults, for the classes of a node table.
topobag::RecognitionOptions table_recognition_options() {
  return topobag::recognition_options(topobag::ClassCatalog::coco80());
}

/// What a front end knows of a key frame of its map.
topobag::EntryInfo info_of(const Keyframe& keyframe) {
  topobag::EntryInfo info;
  info.stamp = keyframe.timestamp;
  info.T_world_camera = keyframe.T_world_camera;
  return info;
}

topobag::Relocalizer<> relocalizer_of(const std::vector<Keyframe>& map) {
  topobag::Relocalizer<> relocalizer(table_recognition_options());
  for (std::size_t i = 0; i < map.size(); ++i) {
    if (!map[i].graph.is_matchable()) continue;
    relocalizer.map().add(topobag::KeyframeId{i}, map[i].graph, info_of(map[i]));
  }
  return relocalizer;
}

/// What `recognize` says, and the time it took.
template <typename Recognize>
LookUp timed(const Recognize& recognize) {
  const Stopwatch watch;
  topobag::Recognition recognition = recognize();
  return {std::move(recognition), watch.milliseconds(), {}, {}};
}

/// Learns from the map of a run.
/// @param min_gap  s; a key frame with a pose is not looked up among those nearer in time
topobag::Calibration learn(const RecognitionRun& run, const std::vector<Keyframe>& other_places,
                           std::optional<double> min_gap) {
  const topobag::Relocalizer<> relocalizer = relocalizer_of(run.map);
  std::vector<topobag::KeyframeId> ids;
  for (std::size_t i = 0; i < run.map.size(); ++i) ids.push_back(topobag::KeyframeId{i});
  const auto usable =
      std::count_if(other_places.begin(), other_places.end(),
                    [](const Keyframe& other) { return other.graph.is_matchable(); });
  topobag::CalibrateOptions options;
  if (min_gap) options.by_pose.min_time_gap = *min_gap;
  if (static_cast<std::size_t>(usable) >= options.calibration.min_negatives) {
    options.null_look_ups = 0;
  }
  topobag::Calibration calibration = topobag::calibrate(relocalizer, ids, {}, options);
  const auto open = topobag::without_threshold(relocalizer.options());
  for (const Keyframe& other : other_places) {
    if (!other.graph.is_matchable()) continue;
    topobag::add_negative(calibration, relocalizer.localize(other.graph, open));
  }
  return calibration;
}

/// The program's options with the decision that was asked for, which the run then tells of.
topobag::RecognitionOptions decided_options(RecognitionRun& run, const CalibrationRequest& request,
                                            std::optional<double> min_gap = std::nullopt) {
  topobag::RecognitionOptions options = table_recognition_options();
  options.decision.false_accept_rate = request.false_accept_rate;
  run.calibrated.reset();
  if (request.learnt) {
    run.calibrated = {request.false_accept_rate, *request.learnt};
  } else if (request.learn) {
    run.calibrated = {request.false_accept_rate, learn(run, request.other_places, min_gap)};
  }
  if (run.calibrated) options.decision.calibration = run.calibrated->calibration;
  return options;
}

}  // namespace

void look_up_in_map(RecognitionRun& run, const CalibrationRequest& request) {
  const topobag::RecognitionOptions options = decided_options(run, request);
  const topobag::Relocalizer<> relocalizer = relocalizer_of(run.map);
  run.look_ups.clear();
  for (const Keyframe& query : run.queries) {
    run.look_ups.push_back(timed([&] { return relocalizer.localize(query.graph, options); }));
  }
}

topobag::Explanation explain_look_up(const RecognitionRun& run, std::size_t index) {
  const topobag::Recognition& recognition = run.look_ups[index].recognition;
  topobag::Explanation explanation =
      topobag::explain(recognition, relocalizer_of(run.map).map(), run.queries[index].graph,
                       topobag::ClassCatalog::coco80(), table_recognition_options());
  for (topobag::CandidateExplanation& candidate : explanation.candidates) {
    const auto frame_of = [&](topobag::KeyframeId id) {
      return topobag::KeyframeId{static_cast<std::uint64_t>(run.map[topobag::value(id)].idx)};
    };
    candidate.id = frame_of(candidate.id);
    if (candidate.rival) candidate.rival->id = frame_of(candidate.rival->id);
  }
  return explanation;
}

void look_up_earlier(RecognitionRun& run, double min_gap, const CalibrationRequest& request) {
  topobag::LoopDetector<> loops({min_gap, decided_options(run, request, min_gap)});
  run.look_ups.clear();
  for (std::size_t i = 0; i < run.queries.size(); ++i) {
    const Keyframe& query = run.queries[i];
    run.look_ups.push_back(timed([&] { return loops.detect(query.timestamp, query.graph); }));
    if (!query.graph.is_matchable()) continue;
    loops.bag().add(topobag::KeyframeId{i}, query.graph, info_of(query));
  }
}

void verify(RecognitionRun& run, const std::vector<std::vector<topobag::Candidate>>& candidates) {
  const topobag::Relocalizer<> relocalizer = relocalizer_of(run.map);
  const topobag::RecognitionOptions& options = relocalizer.options();
  run.look_ups.clear();
  for (std::size_t i = 0; i < run.queries.size(); ++i) {
    run.look_ups.push_back(timed([&] {
      return topobag::verify_candidates(relocalizer.map(), run.queries[i].graph, candidates[i],
                                        options);
    }));
  }
}

}  // namespace program
