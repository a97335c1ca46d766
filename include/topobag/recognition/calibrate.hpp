// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include <topobag/matching/appearance_model.hpp>
#include <topobag/recognition/calibration.hpp>
#include <topobag/recognition/certain_negatives.hpp>
#include <topobag/recognition/detail/learnt_looks.hpp>
#include <topobag/recognition/null_model.hpp>
#include <topobag/recognition/recognition.hpp>
#include <topobag/recognition/relocalizer.hpp>
#include <topobag/types/ids.hpp>

namespace topobag {
inline namespace v0 {

/// Says of two key frames that they cannot be of one place: what the front end knows by odometry, a
/// floor plan or the session.
using OtherPlaces = std::function<bool(KeyframeId, KeyframeId)>;

/// How a map is asked for its own false scores.
struct CalibrateOptions {
  std::size_t null_queries = 400;    ///< when the map has too few certain negatives
  std::uint32_t seed = 1;            ///< of the null model
  PoseNegativeOptions by_pose{};     ///< what is false of key frames with a pose in the world
  CalibrationOptions calibration{};  ///< how scores become rates
  std::function<void()> on_query;    ///< when set, called after each, to tell how far it has come
  std::optional<AppearanceModel> appearance{};  ///< what looks say (`learn_map_appearance`): scores
                                                ///< are made with it, the calibration keeps it
};

namespace detail {

/// What looks are judged by while a map is asked, and afterwards; nothing where that is left to the
/// matching's options. Throws InvalidValue when the map's looks are of another kind.
template <typename Bag>
std::optional<AppearanceModel> looks_to_keep(const Relocalizer<Bag>& relocalizer,
                                             const CalibrateOptions& options) {
  if (!options.appearance) {
    const AppearanceModel* before = learnt_looks(relocalizer.map(), relocalizer.options());
    return before ? std::make_optional(*before) : std::nullopt;
  }
  require_kind_of(relocalizer.map(), options.appearance->kind);
  return options.appearance;
}

/// Which of `size` things is the i-th of `draws` that are spread evenly over all of them, or, when
/// they are fewer, that go round them.
inline std::size_t even_draw(std::size_t i, std::size_t draws, std::size_t size) {
  return draws < size ? i * size / draws : i % size;
}

/// Permuted layouts of the key frames, drawn evenly, looked up in the whole map.
/// @param recognition  without a threshold
template <typename Bag>
void add_null_queries(Calibration& calibration, const Relocalizer<Bag>& relocalizer,
                      const RecognitionOptions& recognition,
                      const std::vector<KeyframeId>& keyframes, const CalibrateOptions& options) {
  for (std::size_t i = 0; i < options.null_queries; ++i) {
    const std::size_t drawn = even_draw(i, options.null_queries, keyframes.size());
    const auto graph = relocalizer.map().find(keyframes[drawn]);
    if (!graph) continue;  // erased meanwhile
    const auto layout = permuted_layout(*graph, options.seed + static_cast<std::uint32_t>(i));
    const Recognition found = relocalizer.localize(layout, recognition);
    if (!found.candidates.empty()) calibration.add_null(false_score(found), found.places);
    if (options.on_query) options.on_query();
  }
}

}  // namespace detail

/// Learns from a map itself. Every key frame with a pose in the world is looked up in the map
/// without itself and its neighbours in time, and the best match that puts it elsewhere is false;
/// every other one is looked up among those that `other_places` says cannot be its place. If that
/// gives too few certain negatives, as in a map of one place, permuted layouts of key frames from
/// all over the map are looked up in it. Deterministic. Throws InvalidValue for a model of looks
/// that is none, or of another kind than the map's. Cost: a query for each.
///
///     Calibration calibration = calibrate(relocalizer, ids, other_places);
///     options.decision.calibration = calibration;  // and options.decision.false_accept_rate
template <typename Bag>
Calibration calibrate(const Relocalizer<Bag>& relocalizer, const std::vector<KeyframeId>& keyframes,
                      const OtherPlaces& other_places = {}, const CalibrateOptions& options = {}) {
  Calibration calibration(options.calibration);
  std::vector<KeyframeId> usable;
  RecognitionOptions recognition = without_threshold(relocalizer.options());
  if (const auto looks = detail::looks_to_keep(relocalizer, options)) {
    calibration.set_appearance(*looks);
    recognition.matching.chance.appearance = *looks;
  }
  const RecognitionOptions in_whole_map = recognition;
  const auto wanted = recognition.retrieval.filter;
  const auto look_up = [&](const auto& graph, const auto& admitted) {
    recognition.retrieval.filter = [&](KeyframeId entry, const EntryInfo& info) {
      return admitted(entry, info) && (!wanted || wanted(entry, info));
    };
    return relocalizer.localize(graph, recognition);
  };
  for (const KeyframeId id : keyframes) {
    const auto graph = relocalizer.map().find(id);
    if (!graph || !graph->is_matchable()) continue;
    usable.push_back(id);
    const auto known = detail::stored_info(relocalizer.map(), id, 0);
    if (known && known->T_world_camera) {
      const Recognition found = look_up(*graph, [&](KeyframeId entry, const EntryInfo& info) {
        return !options.by_pose.is_neighbor(id, *known, entry, info);
      });
      add_negative_by_pose(calibration, found, relocalizer.map(), *known->T_world_camera,
                           options.by_pose);
    } else if (other_places) {
      add_negative(calibration, look_up(*graph, [&](KeyframeId entry, const EntryInfo&) {
                     return other_places(id, entry);
                   }));
    }
    if (options.on_query) options.on_query();
  }
  if (calibration.source() == CalibrationSource::null_model && !usable.empty()) {
    detail::add_null_queries(calibration, relocalizer, in_whole_map, usable, options);
  }
  return calibration;
}

}  // namespace v0
}  // namespace topobag
