// SPDX-License-Identifier: MIT
#include "look_up.hpp"

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

#include <topobag/recognition/explain.hpp>
#include <topobag/recognition/loop_detector.hpp>
#include <topobag/recognition/place_score.hpp>
#include <topobag/recognition/relocalizer.hpp>

#include "input_error.hpp"
#include "learning_conditions.hpp"
#include "learnt_calibration.hpp"
#include "progress.hpp"
#include "run_map.hpp"
#include "stopwatch.hpp"

namespace program {
namespace {

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

/// The program's options with the decision that was asked for, which the run then tells of.
topobag::RecognitionOptions decided_options(RecognitionRun& run, const CalibrationRequest& request,
                                            std::optional<double> min_gap = std::nullopt) {
  run.calibrated.reset();
  if (request.learnt) {
    run.calibrated = {request.false_accept_rate, *request.learnt};
    run.calibrated->other_map = is_of_other_map(*request.learnt, request.conditions);
    if (request.learnt->appearance()) run.calibrated->looks = "as learnt before";
  } else if (request.learn) {
    run.calibrated = learnt_calibration(run, request, min_gap);
    run.calibrated->calibration.set_conditions(request.conditions);
    run.calibrated->other_map = false;
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
