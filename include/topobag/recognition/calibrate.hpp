// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include <topobag/recognition/calibration.hpp>
#include <topobag/recognition/null_model.hpp>
#include <topobag/recognition/recognition.hpp>
#include <topobag/recognition/relocalizer.hpp>

namespace topobag {
inline namespace v0 {

/// Options under which a look-up shows its score whatever it is, for `false_score`.
inline RecognitionOptions without_threshold(RecognitionOptions options) {
  options.decision.calibration.reset();
  options.decision.min_score = -1e6;
  options.place.min_score = -1e6;
  return options;
}

/// The least threshold that would have refused a look-up made `without_threshold`; nothing when it
/// was refused for another reason.
inline std::optional<double> false_score(const Recognition& recognition) {
  if (!recognition) return std::nullopt;
  return recognition.accepted->score();
}

/// Says of two key frames that they cannot be of one place: what the front end knows by odometry, a
/// floor plan or the session.
using OtherPlaces = std::function<bool(KeyframeId, KeyframeId)>;

/// How a map is asked for its own false scores.
struct CalibrateOptions {
  std::size_t null_look_ups = 400;   ///< when the map has too few certain negatives
  std::uint32_t seed = 1;            ///< of the null model
  CalibrationOptions calibration{};  ///< how scores become rates
};

/// Learns from a map itself: every key frame is looked up among those that `other_places` says
/// cannot be its place; if that gives too few certain negatives, permuted layouts of the key frames
/// are looked up in the whole map. Deterministic. Cost: a look-up each.
///
///     Calibration calibration = calibrate(relocalizer, ids, other_places);
///     options.decision.calibration = calibration;  // and options.decision.false_accept_rate
template <typename Bag>
Calibration calibrate(const Relocalizer<Bag>& relocalizer, const std::vector<KeyframeId>& keyframes,
                      const OtherPlaces& other_places = {}, const CalibrateOptions& options = {}) {
  Calibration calibration(options.calibration);
  std::vector<typename Bag::Graph> graphs;
  RecognitionOptions recognition = without_threshold(relocalizer.options());
  const auto wanted = recognition.retrieval.filter;
  for (const KeyframeId id : keyframes) {
    auto graph = relocalizer.map().find(id);
    if (!graph || !graph->is_matchable()) continue;
    if (other_places) {
      recognition.retrieval.filter = [&](KeyframeId entry, const EntryInfo& info) {
        return other_places(id, entry) && (!wanted || wanted(entry, info));
      };
      const Recognition found = relocalizer.localize(*graph, recognition);
      if (!found.candidates.empty()) calibration.add_negative(false_score(found));
    }
    if (graphs.size() < options.null_look_ups) graphs.push_back(std::move(*graph));
  }
  if (calibration.source() == CalibrationSource::certain_negatives || graphs.empty()) {
    return calibration;
  }
  recognition.retrieval.filter = wanted;
  for (std::size_t i = 0; i < options.null_look_ups; ++i) {
    const auto seed = options.seed + static_cast<std::uint32_t>(i);
    const auto layout = permuted_layout(graphs[i % graphs.size()], seed);
    const Recognition found = relocalizer.localize(layout, recognition);
    if (!found.candidates.empty()) calibration.add_null(false_score(found));
  }
  return calibration;
}

}  // namespace v0
}  // namespace topobag
