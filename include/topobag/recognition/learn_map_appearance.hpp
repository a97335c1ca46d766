// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <functional>
#include <set>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include <topobag/bag/detail/present_view.hpp>
#include <topobag/bag/entry_info.hpp>
#include <topobag/bag/query.hpp>
#include <topobag/matching/appearance_counts.hpp>
#include <topobag/matching/coincident_objects.hpp>
#include <topobag/matching/learn_appearance.hpp>
#include <topobag/matching/point_pair.hpp>
#include <topobag/recognition/certain_negatives.hpp>
#include <topobag/recognition/detail/stored_entry.hpp>
#include <topobag/recognition/recognition.hpp>
#include <topobag/recognition/recognition_options.hpp>
#include <topobag/recognition/relocalizer.hpp>
#include <topobag/types/ids.hpp>

namespace topobag {
inline namespace v0 {

/// What of a map whose key frames' poses are known is one object, and what are two.
struct MapAppearanceOptions {
  PoseNegativeOptions right{0.3, 0.26};  ///< m and rad (15°): a match that puts the query nearer to
                                         ///< where it is is right; and which are neighbours in time
  double min_separation = 0.5;     ///< m in the world; objects of a class that are further apart,
  CoincidenceOptions apart{};      ///< and by more than these deviations, are two
  std::function<void()> on_query;  ///< when set, called after each key frame
};

namespace detail {

/// A query to learn looks from: its matches are found without them, lest only what looks alike be
/// taken for one object.
inline RecognitionOptions without_looks(RecognitionOptions options) {
  options.decision.calibration.reset();
  options.matching.chance.appearance.table.clear();
  options.matching.scale.reset();  // a map is in its own unit
  return options;
}

/// Counts the objects of a class of two key frames that are two by the poses in the world.
template <typename Graph>
void count_apart(AppearanceCounts& counts, const Graph& candidate, const Graph& query,
                 const Eigen::Isometry3d& T_candidate_query, const MapAppearanceOptions& options) {
  const double deviations2 = options.apart.deviations * options.apart.deviations;
  for (const auto& p : candidate.nodes()) {
    for (const auto& q : query.nodes()) {
      if (p.label != q.label || !p.position || !q.position) continue;
      const PointPair points = point_pair(p, q, options.apart.noise);
      if (points.residual(T_candidate_query).norm() <= options.min_separation) continue;
      if (points.squared_deviation(T_candidate_query) <= deviations2) continue;
      counts.add_other(p.appearance, q.appearance);
    }
  }
}

}  // namespace detail

/// Counts what a map itself says of its objects' looks. Every key frame with a pose in the world is
/// looked up in the map without itself and its neighbours in time, looks left out: verified matches
/// that are right by the poses bring together what is one object, and of every candidate the
/// objects of a class that the poses put apart are two (certain negatives). Each two key frames
/// count once. What is learnt is what this map can show: where all was seen in one light, it does
/// not know another. Deterministic. Cost: a query for each key frame.
///
///     AppearanceCounts counts(relocalizer.map().appearance_kind());
///     learn_map_appearance(counts, relocalizer, ids);
///     options.appearance = counts.model();  // of CalibrateOptions
///     Calibration calibration = calibrate(relocalizer, ids, other_places, options);
template <typename Bag>
void learn_map_appearance(AppearanceCounts& counts, const Relocalizer<Bag>& relocalizer,
                          const std::vector<KeyframeId>& keyframes,
                          const MapAppearanceOptions& options = {}) {
  RecognitionOptions recognition = detail::without_looks(relocalizer.options());
  const auto wanted = recognition.retrieval.filter;
  std::set<std::pair<KeyframeId, KeyframeId>> matched, compared;
  for (const KeyframeId id : keyframes) {
    const auto graph = relocalizer.map().find(id);
    const auto info = detail::stored_info(relocalizer.map(), id, 0);
    if (!graph || !graph->is_matchable() || !info || !info->T_world_camera) continue;
    recognition.retrieval.filter = [&](KeyframeId entry, const EntryInfo& entry_info) {
      return !options.right.is_neighbor(id, *info, entry, entry_info) &&
             (!wanted || wanted(entry, entry_info));
    };
    for (const CandidateReport& report : relocalizer.localize(*graph, recognition).candidates) {
      const auto candidate = relocalizer.map().find(report.id);
      const auto T_world_candidate = detail::known_pose(relocalizer.map(), report.id);
      if (!candidate || !T_world_candidate) continue;
      const std::pair<KeyframeId, KeyframeId> both = std::minmax(id, report.id);
      if (is_verified(report.verdict) &&
          !detail::is_elsewhere(report, *T_world_candidate, *info->T_world_camera, options.right) &&
          matched.insert(both).second) {
        learn_appearance(counts, *candidate, *graph, *report.pose, options.apart);
      }
      if (compared.insert(both).second) {
        detail::count_apart(counts, *candidate, *graph,
                            T_world_candidate->inverse() * *info->T_world_camera, options);
      }
    }
    if (options.on_query) options.on_query();
  }
}

/// Counts what a key frame that is certainly of no place in the map says of looks: beside those
/// entries that retrieval takes for it (`learn_other_appearance`). O(a retrieval).
template <typename Bag>
void learn_elsewhere_appearance(AppearanceCounts& counts, const Relocalizer<Bag>& relocalizer,
                                const typename Relocalizer<Bag>::Graph& elsewhere) {
  const auto map = detail::present_view(relocalizer.map(), 0);
  for (const Candidate& candidate : map->query(elsewhere, relocalizer.options().retrieval)) {
    const auto graph = detail::stored_graph(*map, candidate.id, 0);
    if (graph) learn_other_appearance(counts, *graph, elsewhere);
  }
}

}  // namespace v0
}  // namespace topobag
