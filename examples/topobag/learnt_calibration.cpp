// SPDX-License-Identifier: MIT
#include "learnt_calibration.hpp"

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include <topobag/recognition/calibrate.hpp>
#include <topobag/recognition/learn_map_appearance.hpp>

#include "input_error.hpp"
#include "progress.hpp"
#include "run_map.hpp"

namespace program {
namespace {

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

}  // namespace

CalibratedRun learnt_calibration(const RecognitionRun& run, const CalibrationRequest& request,
                                 std::optional<double> min_gap) {
  const std::vector<Keyframe>& other_places = request.other_places;
  require_elsewhere(run, other_places);
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

}  // namespace program
