// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <type_traits>
#include <utility>

#include <Eigen/Geometry>

#include <topobag/bag/bag_concepts.hpp>
#include <topobag/bag/bag_of_topology_graphs.hpp>
#include <topobag/recognition/recognition.hpp>
#include <topobag/recognition/recognition_options.hpp>
#include <topobag/recognition/verify_candidates.hpp>

namespace topobag {
inline namespace v0 {

namespace detail {

/// The bag's view where it has one, else the bag itself.
template <typename Bag>
auto present_view(const Bag& bag, int) -> decltype(bag.view()) {
  return bag.view();
}
template <typename Bag>
const Bag* present_view(const Bag& bag, long) {
  return &bag;
}

template <typename Bag>
using PresentView = std::decay_t<decltype(*present_view(std::declval<const Bag&>(), 0))>;

}  // namespace detail

/// Finds a lost camera in a map. With an `IndexedBag`, one thread may add to the map while others
/// localize.
///
///     Relocalizer<> relocalizer;
///     for (each key frame) relocalizer.map().add(id, graph, info);
///     const Recognition found = relocalizer.localize(query_graph);
///     if (found) use(found.accepted->pose->T_candidate_query);
template <typename Bag_ = BagOfTopologyGraphs<>>
class Relocalizer {
  static_assert(is_look_up_bag_v<detail::PresentView<Bag_>>,
                "topobag: a bag to look up in has Graph = TopologyGraph<Scalar>, query(graph, "
                "QueryOptions) const -> std::vector<Candidate> and find(KeyframeId) const -> "
                "std::optional<Graph>, or a view() that has.");

 public:
  using Bag = Bag_;
  using Graph = typename Bag::Graph;

  /// `map`: filled already, or with a similarity of yours.
  explicit Relocalizer(RecognitionOptions options = {}, Bag map = Bag{})
      : options_(std::move(options)), map_(std::move(map)) {}

  /// The map, to be filled.
  Bag& map() noexcept { return map_; }
  /// The same, to be read.
  const Bag& map() const noexcept { return map_; }

  /// Where in the map the query was taken, and why, or why not. The query is not added.
  /// Deterministic. O(n · similarity + max_candidates · matching).
  Recognition localize(const Graph& query) const { return localize(query, options_); }

  /// The same with options for this query alone.
  Recognition localize(const Graph& query, const RecognitionOptions& options) const {
    QueryOptions retrieval = options.retrieval;
    retrieval.max_results = options.max_candidates;
    // Asked and verified as it is now, whatever a writer does meanwhile.
    const auto map = detail::present_view(map_, 0);
    return verify_candidates(*map, query, map->query(query, retrieval), options);
  }

  /// Those of every query that brings none.
  const RecognitionOptions& options() const noexcept { return options_; }
  /// From the next query on; a calibration comes in by this. Not while another thread looks up.
  void set_options(RecognitionOptions options) { options_ = std::move(options); }

  /// The query camera's pose in the map's world, when it was recognised and the matched entry's
  /// pose is known.
  std::optional<Eigen::Isometry3d> T_world_query(const Recognition& recognition) const {
    if (!recognition) return std::nullopt;
    const auto info = map_.info(recognition.accepted->id);
    if (!info || !info->T_world_camera) return std::nullopt;
    return *info->T_world_camera * recognition.accepted->pose->T_candidate_query;
  }

 private:
  RecognitionOptions options_;
  Bag map_;
};

}  // namespace v0
}  // namespace topobag
