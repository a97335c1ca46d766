// SPDX-License-Identifier: MIT
#include "look_up.hpp"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <optional>
#include <utility>

#include <topobag/recognition/calibrate.hpp>
#include <topobag/recognition/explain.hpp>
#include <topobag/recognition/learn_map_appearance.hpp>
#include <topobag/recognition/loop_detector.hpp>
#include <topobag/recognition/place_score.hpp>
#include <topobag/recognition/relocalizer.hpp>

#include "input_error.hpp"
#include "progress.hpp"
#include "stopwatch.hpp"

namespace program {
namespace {

/// What a front end knows of a key frame of its map.
topobag::EntryInfo info_of(const Keyframe& keyframe) {
  topobag::EntryInfo info;
  info.stamp = keyframe.timestamp;
  info.T_world_camera = keyframe.T_world_camera;
  if (keyframe.saved) info.session = keyframe.saved->session.id;
  return info;
}

/// The program's options for a run, with the decision that it was calibrated for. A map of objects
/// was seen by no camera, so that it has no direction that one would look in again.
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

/// The map of a run.
topobag::Relocalizer<> relocalizer_of(const RecognitionRun& run) {
  const std::vector<Keyframe>& map = run.map;
  topobag::Relocalizer<> relocalizer(options_of(run));
  for (std::size_t i = 0; i < map.size(); ++i) {
    if (!map[i].graph.is_matchable()) continue;
    relocalizer.map().add(topobag::KeyframeId{i}, map[i].graph, info_of(map[i]));
  }
  return relocalizer;
}

TriedCandidate tried_candidate(const topobag::CandidateReport& report) {
  TriedCandidate tried;
  tried.candidate = topobag::value(report.id);
  tried.verdict = report.verdict;
  tried.similarity = report.similarity;
  tried.place_score = topobag::place_score(report);
  if (!report.pose) return tried;
  tried.objects = static_cast<std::uint32_t>(report.pose->inliers.size());
  tried.score = report.score();
  return tried;
}

/// What `recognize` says, as far as it is kept, and the time it took.
template <typename Recognize>
QueryRecord timed(KeptCandidates kept, const Recognize& recognize) {
  const Stopwatch watch;
  topobag::Recognition recognition = recognize();
  QueryRecord record;
  record.milliseconds = watch.milliseconds();
  auto& reports = recognition.candidates;
  if (kept == KeptCandidates::tried) {
    std::transform(reports.begin(), reports.end(), std::back_inserter(record.tried),
                   tried_candidate);
  }
  if (kept != KeptCandidates::reports && reports.size() > 1) {
    reports.erase(reports.begin() + 1, reports.end());
    reports.shrink_to_fit();
  }
  record.recognition = std::move(recognition);
  return record;
}

/// Throws InputError where key frames that shall be of other places are the map's own.
void require_elsewhere(const RecognitionRun& run, const std::vector<Keyframe>& other_places) {
  RecognitionRun own;
  own.map = run.map;
  own.queries = other_places;
  const std::size_t count = count_in_map(own);
  if (count == 0) return;
  throw InputError("--other-place", std::to_string(count) + " of its " +
                                        std::to_string(other_places.size()) +
                                        " key frames are the map's own, which are no other place");
}

/// What the looks of the map's and other places' objects say; nothing where they have none, or are
/// too few to tell, which `sentence` tells.
std::optional<topobag::AppearanceModel> learnt_looks(const topobag::Relocalizer<>& relocalizer,
                                                     const std::vector<topobag::KeyframeId>& ids,
                                                     const std::vector<Keyframe>& other_places,
                                                     double min_gap, std::string& sentence) {
  const topobag::AppearanceKind kind = relocalizer.map().appearance_kind();
  if (kind.length() == 0) return std::nullopt;
  topobag::AppearanceCounts counts(kind);
  topobag::MapAppearanceOptions options;
  options.right.min_time_gap = min_gap;
  Progress progress(ids.size(), "key frames to learn looks from at most");
  options.on_query = [&] { progress.step(); };
  topobag::learn_map_appearance(counts, relocalizer, ids, options);
  for (const Keyframe& other : other_places) {
    topobag::learn_elsewhere_appearance(counts, relocalizer, other.graph);
  }
  sentence = "learnt of " + std::to_string(counts.same()) + " pairs of one object and " +
             std::to_string(counts.other()) + " of two";
  const std::size_t least = topobag::AppearancePrior{}.min_pairs;
  if (std::min(counts.same(), counts.other()) >= least) return counts.model();
  sentence = "not " + sentence + "; it takes " + std::to_string(least) + " of either";
  return std::nullopt;
}

/// Learns from the map of a run.
/// @param min_gap  s; a key frame with a pose is not looked up among those nearer in time
CalibratedRun learn(const RecognitionRun& run, const CalibrationRequest& request,
                    std::optional<double> min_gap) {
  const std::vector<Keyframe>& other_places = request.other_places;
  const topobag::Relocalizer<> relocalizer = relocalizer_of(run);
  std::vector<topobag::KeyframeId> ids;
  for (std::size_t i = 0; i < run.map.size(); ++i) ids.push_back(topobag::KeyframeId{i});
  const auto usable =
      std::count_if(other_places.begin(), other_places.end(),
                    [](const Keyframe& other) { return other.graph.is_matchable(); });
  topobag::CalibrateOptions options;
  if (min_gap) options.by_pose.min_time_gap = *min_gap;
  if (static_cast<std::size_t>(usable) >= options.calibration.min_negatives) {
    options.null_queries = 0;
  }
  CalibratedRun calibrated{request.false_accept_rate};
  options.appearance =
      learnt_looks(relocalizer, ids, other_places, options.by_pose.min_time_gap, calibrated.looks);
  // A null model is only asked where the map's poses do not tell enough, which turns out later.
  Progress progress(ids.size() + options.null_queries, "queries to learn from at most");
  options.on_query = [&] { progress.step(); };
  calibrated.calibration = topobag::calibrate(relocalizer, ids, {}, options);
  topobag::RecognitionOptions open = relocalizer.options();
  open.decision.calibration = calibrated.calibration;  // for what it learnt of looks
  open = topobag::without_threshold(open);
  for (const Keyframe& other : other_places) {
    if (!other.graph.is_matchable()) continue;
    topobag::add_negative(calibrated.calibration, relocalizer.localize(other.graph, open));
  }
  return calibrated;
}

/// The program's options with the decision that was asked for, which the run then tells of.
topobag::RecognitionOptions decided_options(RecognitionRun& run, const CalibrationRequest& request,
                                            std::optional<double> min_gap = std::nullopt) {
  run.calibrated.reset();
  if (request.learnt) {
    run.calibrated = {request.false_accept_rate, *request.learnt};
    if (request.learnt->appearance()) run.calibrated->looks = "as learnt before";
  } else if (request.learn) {
    require_elsewhere(run, request.other_places);
    run.calibrated = learn(run, request, min_gap);
  }
  topobag::RecognitionOptions options = options_of(run);
  options.decision.false_accept_rate = request.false_accept_rate;
  return options;
}

}  // namespace

void look_up_in_map(RecognitionRun& run, const CalibrationRequest& request,
                    std::optional<double> leave_out_radius) {
  if (leave_out_radius) require_poses(run, "--leave-out-radius");
  topobag::RecognitionOptions options = decided_options(run, request);
  const topobag::Relocalizer<> relocalizer = relocalizer_of(run);
  if (run.calibrated) run.calibrated->places = relocalizer.map().places();
  run.records.clear();
  run.leave_out_radius = leave_out_radius;
  run.left_out_of_map = 0;
  Progress progress(run.queries.size(), "key frames looked up");
  for (const Keyframe& query : run.queries) {
    if (leave_out_radius) {
      const topobag::MapRegion own{query.T_world_camera->translation(), *leave_out_radius};
      options.retrieval.filter = [own](topobag::KeyframeId, const topobag::EntryInfo& info) {
        return !own.contains(info.T_world_camera->translation());
      };
      run.left_out_of_map += static_cast<std::size_t>(
          std::count_if(run.map.begin(), run.map.end(), [&](const Keyframe& keyframe) {
            return own.contains(keyframe.T_world_camera->translation());
          }));
    }
    run.records.push_back(
        timed(run.kept, [&] { return relocalizer.localize(query.graph, options); }));
    progress.step();
  }
}

topobag::Explanation explain_look_up(const RecognitionRun& run, std::size_t index) {
  const topobag::Recognition& recognition = run.records[index].recognition;
  return topobag::explain(recognition, relocalizer_of(run).map(), run.queries[index].graph,
                          run.classes.catalog, options_of(run), recognition.candidates.size());
}

topobag::CandidateExplanation explain_accepted(const RecognitionRun& run, std::size_t index) {
  const topobag::CandidateReport& accepted = *run.records[index].recognition.accepted;
  return topobag::explain_candidate(accepted, run.map[topobag::value(accepted.id)].graph,
                                    run.queries[index].graph, run.classes.catalog, options_of(run),
                                    accepted.margin());
}

void look_up_earlier(RecognitionRun& run, double min_gap, const CalibrationRequest& request) {
  topobag::LoopDetector<> loops({min_gap, decided_options(run, request, min_gap)});
  run.records.clear();
  Progress progress(run.map.size(), "key frames looked up");
  for (std::size_t i = 0; i < run.map.size(); ++i) {
    const Keyframe& keyframe = run.map[i];
    const std::size_t next = run.records.size();
    if (next < run.queries.size() && run.queries[next].idx == keyframe.idx) {
      run.records.push_back(
          timed(run.kept, [&] { return loops.detect(keyframe.timestamp, keyframe.graph); }));
    }
    progress.step();
    if (!keyframe.graph.is_matchable()) continue;
    loops.bag().add(topobag::KeyframeId{i}, keyframe.graph, info_of(keyframe));
  }
  if (run.calibrated) run.calibrated->places = loops.bag().places();
}

void verify(RecognitionRun& run, const std::vector<std::vector<topobag::Candidate>>& candidates) {
  const topobag::Relocalizer<> relocalizer = relocalizer_of(run);
  const topobag::RecognitionOptions& options = relocalizer.options();
  run.records.clear();
  Progress progress(run.queries.size(), "key frames verified");
  for (std::size_t i = 0; i < run.queries.size(); ++i) {
    run.records.push_back(timed(run.kept, [&] {
      return topobag::verify_candidates(relocalizer.map(), run.queries[i].graph, candidates[i],
                                        options);
    }));
    progress.step();
  }
}

}  // namespace program
