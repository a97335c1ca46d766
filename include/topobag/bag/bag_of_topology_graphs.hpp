// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <topobag/bag/detail/camera_grid.hpp>
#include <topobag/bag/detail/entry_key.hpp>
#include <topobag/bag/detail/histogram_index.hpp>
#include <topobag/bag/entry_filter.hpp>
#include <topobag/bag/entry_info.hpp>
#include <topobag/bag/place_count.hpp>
#include <topobag/bag/query.hpp>
#include <topobag/bag/savable_graph.hpp>
#include <topobag/error.hpp>
#include <topobag/graph/topology_graph.hpp>
#include <topobag/similarity/class_pair_distance_histogram.hpp>
#include <topobag/similarity/similarity.hpp>
#include <topobag/types/ids.hpp>

namespace topobag {
inline namespace v0 {

/// The paper's bag of topology graphs: one graph per key frame, asked for those that resemble a
/// query.
///
/// A query compares every entry; a similarity with a `descriptor` has it worked out once, at `add`,
/// and one that is a `jaccard` (`is_jaccard_v`) costs no more than what entries have in common with
/// the query. Results do not depend on the order in which entries came.
template <typename Graph_ = TopologyGraph<double>,
          typename Similarity_ = ClassPairDistanceHistogram>
class BagOfTopologyGraphs {
 public:
  using Graph = Graph_;
  using Similarity = Similarity_;
  static_assert(
      is_similarity_v<Similarity, Graph>,
      "topobag: a similarity is callable as similarity(graph, graph) -> double in [0, 1].");

  /// An empty bag.
  explicit BagOfTopologyGraphs(Similarity similarity = {}) : similarity_(std::move(similarity)) {}

  /// Puts a key frame's graph into the bag. Throws InvalidId if `id` is there already, InvalidValue
  /// as `EntryInfo::validate` and, of a `TopologyGraph`, `require_savable` and for descriptors of
  /// another kind than the bag's. O(log n + descriptor).
  void add(KeyframeId id, Graph graph, EntryInfo info = {}) {
    if (contains(id)) {
      throw InvalidId("key frame " + std::to_string(value(id)) +
                      " is in the bag already: use update");
    }
    const AppearanceKind kind = kind_with(graph);
    auto entry = make_entry(std::move(graph), std::move(info));
    auto descriptor = descriptor_of(entry->graph);  // may throw: before anything changes
    appearance_kind_ = kind;
    place(id, *entries_.emplace(id, std::move(entry)).first->second, std::move(descriptor));
  }

  /// Replaces a key frame's graph and info. Throws InvalidId if `id` is not there.
  void update(KeyframeId id, Graph graph, EntryInfo info = {}) {
    const auto it = entries_.find(id);
    if (it == entries_.end()) {
      throw InvalidId("key frame " + std::to_string(value(id)) + " is not in the bag: use add");
    }
    const AppearanceKind kind = kind_with(graph);
    auto entry = make_entry(std::move(graph), std::move(info));
    auto descriptor = descriptor_of(entry->graph);
    appearance_kind_ = kind;
    displace(id, *it->second);
    it->second = std::move(entry);
    place(id, *it->second, std::move(descriptor));
  }

  /// Takes a key frame out; false if it was not there.
  bool erase(KeyframeId id) {
    const auto it = entries_.find(id);
    if (it == entries_.end()) return false;
    displace(id, *it->second);
    entries_.erase(it);
    return true;
  }
  void clear() noexcept {
    entries_.clear();
    places_.clear();
    cameras_.clear();
    index_.clear();
    appearance_kind_ = {};
  }

  bool contains(KeyframeId id) const { return entries_.count(id) != 0; }
  std::size_t size() const noexcept { return entries_.size(); }
  bool empty() const noexcept { return entries_.empty(); }
  /// Different places among the entries. O(1).
  std::size_t places() const noexcept { return places_.size(); }
  /// The most of them that can hold all of `objects`. O(classes²).
  std::size_t places_holding(const ClassCounts& objects, const ClassGroups& groups = {}) const {
    return places_.contents().holding(objects, groups, places());
  }

  /// The one kind of the descriptors that were added; of length 0 where none was.
  AppearanceKind appearance_kind() const noexcept { return appearance_kind_; }

  /// The key frame's graph, or nothing.
  std::optional<Graph> find(KeyframeId id) const {
    const auto it = entries_.find(id);
    if (it == entries_.end()) return std::nullopt;
    return it->second->graph;
  }
  /// The same where it is, or null; until the entry is changed or taken out.
  const Graph* peek(KeyframeId id) const {
    const auto it = entries_.find(id);
    return it == entries_.end() ? nullptr : &it->second->graph;
  }

  /// What is known of the key frame beside its graph, or nothing.
  std::optional<EntryInfo> info(KeyframeId id) const {
    const auto it = entries_.find(id);
    if (it == entries_.end()) return std::nullopt;
    return it->second->info;
  }

  /// Calls f(KeyframeId, const EntryInfo&, const Graph&) for every entry that is there when the
  /// call begins, by rising id; f may change the bag. O(n).
  template <typename F>
  void for_each(F&& f) const {
    const std::vector<std::pair<KeyframeId, std::shared_ptr<Entry>>> now(entries_.begin(),
                                                                         entries_.end());
    for (const auto& [id, entry] : now) f(id, entry->info, entry->graph);
  }

  /// The key frames whose cameras stand in the region, by rising id; without a pose they are
  /// nowhere. O(log n · rows of 3 m cells that it meets + key frames in these).
  std::vector<KeyframeId> within(const MapRegion& region) const { return cameras_.within(region); }

  /// The entries most similar to `graph`, best first, ties by id. O(n · similarity). An options'
  /// `filter` need not be asked of an entry that is not among the best anyway.
  std::vector<Candidate> query(const Graph& graph, const QueryOptions& options = {}) const {
    const auto key = key_of(graph);
    if constexpr (indexed) {
      const bool restricts = options.restricts();
      return index_.query(key, options, [&](KeyframeId id) {
        return !restricts || options.admits(id, entries_.find(id)->second->info);
      });
    } else {
      return compare_all(key, options);
    }
  }

 private:
  static constexpr bool precomputed = has_descriptor_v<Similarity, Graph>;
  static constexpr bool indexed = is_jaccard_v<Similarity>;

  template <typename Key>
  std::vector<Candidate> compare_all(const Key& key, const QueryOptions& options) const {
    std::vector<Candidate> found;
    for (const auto& [id, entry] : entries_) {
      if (!options.admits(id, entry->info)) continue;
      const double score = score_of(key, *entry);
      if (score >= options.min_score) found.push_back({id, score});
    }
    const std::size_t kept = std::min(options.max_results, found.size());
    std::partial_sort(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(kept),
                      found.end());
    found.resize(kept);
    return found;
  }

  auto key_of(const Graph& graph) const {
    if constexpr (precomputed) {
      return similarity_.descriptor(graph);
    } else {
      return &graph;
    }
  }

  struct Entry {
    Graph graph;
    EntryInfo info;
    typename detail::EntryKey<Similarity, Graph>::type key;
  };

  AppearanceKind kind_with([[maybe_unused]] const Graph& graph) const {
    if constexpr (detail::is_topology_graph_v<Graph>) {
      return common_kind(appearance_kind_, graph.appearance_kind(), "the key frame");
    } else {
      return {};
    }
  }

  std::shared_ptr<Entry> make_entry(Graph graph, EntryInfo info) const {
    info.validate();
    if constexpr (detail::is_topology_graph_v<Graph>) require_savable(graph);
    return std::make_shared<Entry>(Entry{std::move(graph), std::move(info), {}});
  }

  auto descriptor_of([[maybe_unused]] const Graph& graph) const {
    if constexpr (precomputed) {
      return similarity_.descriptor(graph);
    } else {
      return detail::Nothing{};
    }
  }

  static ClassCounts objects_of([[maybe_unused]] const Graph& graph) {
    if constexpr (detail::is_topology_graph_v<Graph>) return class_counts(graph.nodes());
    return {};
  }

  /// Makes an entry known to everything that finds entries.
  template <typename Descriptor>
  void place(KeyframeId id, Entry& entry, [[maybe_unused]] Descriptor descriptor) {
    places_.add(id, entry.info, objects_of(entry.graph));
    cameras_.add(id, entry.info);
    if constexpr (indexed) {
      entry.key = index_.add(id, descriptor);
    } else if constexpr (precomputed) {
      entry.key = std::move(descriptor);
    }
  }
  void displace(KeyframeId id, const Entry& entry) {
    places_.remove(id, entry.info, objects_of(entry.graph));
    cameras_.remove(id, entry.info);
    if constexpr (indexed) index_.remove(entry.key, similarity_.descriptor(entry.graph));
  }

  template <typename Key>
  double score_of(const Key& key, const Entry& entry) const {
    if constexpr (precomputed) {
      return similarity_.similarity(key, entry.key);
    } else {
      return similarity_(*key, entry.graph);
    }
  }

  Similarity similarity_;
  std::map<KeyframeId, std::shared_ptr<Entry>> entries_;  ///< for_each's stay while it walks
  PlaceCount places_;
  detail::CameraGrid cameras_;
  AppearanceKind appearance_kind_;
  std::conditional_t<indexed, detail::HistogramIndex, detail::Nothing> index_;
};

}  // namespace v0
}  // namespace topobag
