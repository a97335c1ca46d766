// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <type_traits>
#include <utility>

#include <topobag/bag/bag_concepts.hpp>
#include <topobag/bag/bag_of_topology_graphs.hpp>
#include <topobag/bag/detail/present_view.hpp>
#include <topobag/recognition/detail/scaled_candidates.hpp>
#include <topobag/recognition/detail/stored_entry.hpp>
#include <topobag/recognition/recognition.hpp>
#include <topobag/recognition/recognition_options.hpp>
#include <topobag/recognition/verify_candidates.hpp>
#include <topobag/types/pose_with_covariance.hpp>
#include <topobag/types/rigid_motion.hpp>

namespace topobag {
inline namespace v0 {

/// Finds a lost camera in a map, which is its own, or one that it refers to. With an `IndexedBag`,
/// one thread may add to the map while others localize.
///
///     const ClassCatalog catalog = ClassCatalog::coco80();
///     Relocalizer<> relocalizer(recognition_options(catalog));  // with a map of its own
///     for (each key frame) relocalizer.map().add(id, graph, info);
///     const Recognition found = relocalizer.localize(query_graph);
///     if (found) use(found.accepted->pose->T_candidate_query);
///
///     SqliteBag<> map("flat.db");
///     Relocalizer lost(map);  // refers to a map that has to outlive it
///
/// Without options it knows nothing of the classes: neither which of them detectors mix up nor how
/// large their objects are.
///
/// @tparam Bag_  a bag; with `&`, one that lives elsewhere: then a copy refers to the same
template <typename Bag_ = BagOfTopologyGraphs<>>
class Relocalizer {
 public:
  using Bag = std::remove_reference_t<Bag_>;
  using Graph = typename Bag::Graph;
  static_assert(is_searchable_bag_v<detail::PresentView<Bag>>,
                "topobag: a bag to query has Graph = TopologyGraph<Scalar>, query(graph, "
                "QueryOptions) const -> std::vector<Candidate> and find(KeyframeId) const -> "
                "std::optional<Graph>, or a view() that has.");

  /// `map`: filled already, or with a similarity of yours; to refer to, where `Bag_` is a
  /// reference.
  explicit Relocalizer(RecognitionOptions options = {}, Bag_ map = std::decay_t<Bag_>{})
      : options_(std::move(options)), map_(std::forward<Bag_>(map)) {}

  /// Refers to `map`.
  template <typename Map, std::enable_if_t<std::is_same_v<Map&, Bag_>, int> = 0>
  explicit Relocalizer(Map& map, RecognitionOptions options = {})
      : Relocalizer(std::move(options), map) {}

  /// The map, to be filled.
  Bag& map() noexcept { return map_; }
  /// The same, to be read.
  const Bag& map() const noexcept { return map_; }

  /// Where in the map the query was taken, and why, or why not. The query is not added.
  /// Deterministic. Throws as `verify_candidates`. O(n · similarity + candidates · matching).
  Recognition localize(const Graph& query) const { return localize(query, options_); }

  /// The same with options for this query alone.
  Recognition localize(const Graph& query, const RecognitionOptions& options) const {
    // Asked and verified as it is now, whatever a writer does meanwhile.
    const auto map = detail::present_view(map_, 0);
    return verify_candidates(*map, query, detail::candidates_of(*map, query, options), options);
  }

  /// Those of every query that brings none.
  const RecognitionOptions& options() const noexcept { return options_; }
  /// From the next query on; a calibration comes in by this. Not while another thread looks up.
  void set_options(RecognitionOptions options) { options_ = std::move(options); }

  /// The query camera's pose in the map's world, when it was recognised and the matched entry's
  /// pose is known, which is taken as exact.
  std::optional<PoseWithCovariance<>> T_world_query(const Recognition& recognition) const {
    if (!recognition) return std::nullopt;
    const std::optional<EntryInfo> info = detail::stored_info(map_, recognition.accepted->id, 0);
    if (!info || !info->T_world_camera) return std::nullopt;
    return T_world_query(recognition, PoseWithCovariance<>{*info->T_world_camera});
  }

  /// The same from the matched entry's pose and its covariance, as the back end knows them. Throws
  /// InvalidValue for a pose that is no rigid motion.
  std::optional<PoseWithCovariance<>> T_world_query(
      const Recognition& recognition, const PoseWithCovariance<>& T_world_candidate) const {
    if (!recognition) return std::nullopt;
    require_rigid(T_world_candidate.T, "the candidate's pose");
    return T_world_candidate * recognition.accepted->pose->with_covariance();
  }

 private:
  RecognitionOptions options_;
  Bag_ map_;
};

/// Of a map that lives elsewhere.
template <typename Bag, std::enable_if_t<is_searchable_bag_v<detail::PresentView<Bag>>, int> = 0>
explicit Relocalizer(Bag&) -> Relocalizer<Bag&>;
/// The same with options.
template <typename Bag, std::enable_if_t<is_searchable_bag_v<detail::PresentView<Bag>>, int> = 0>
explicit Relocalizer(Bag&, RecognitionOptions) -> Relocalizer<Bag&>;

#ifdef TOPOBAG_COMPILED  // in the library topobag::compiled
extern template class Relocalizer<>;
#endif

}  // namespace v0
}  // namespace topobag
