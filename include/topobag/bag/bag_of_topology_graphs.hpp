// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

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
/// A query compares every entry (brute force); a similarity with a `descriptor` has it worked out
/// once, at `add`. Results do not depend on the order in which entries came.
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
  /// as `EntryInfo::validate` and, of a `TopologyGraph`, `require_savable`. O(log n + descriptor).
  void add(KeyframeId id, Graph graph, EntryInfo info = {}) {
    if (contains(id)) {
      throw InvalidId("key frame " + std::to_string(value(id)) +
                      " is in the bag already: use update");
    }
    const auto added = entries_.emplace(id, make_entry(std::move(graph), std::move(info))).first;
    places_.add(id, added->second->info);
  }

  /// Replaces a key frame's graph and info. Throws InvalidId if `id` is not there.
  void update(KeyframeId id, Graph graph, EntryInfo info = {}) {
    const auto it = entries_.find(id);
    if (it == entries_.end()) {
      throw InvalidId("key frame " + std::to_string(value(id)) + " is not in the bag: use add");
    }
    std::shared_ptr<const Entry> entry = make_entry(std::move(graph), std::move(info));
    places_.remove(id, it->second->info);
    it->second = std::move(entry);
    places_.add(id, it->second->info);
  }

  /// Takes a key frame out; false if it was not there.
  bool erase(KeyframeId id) {
    const auto it = entries_.find(id);
    if (it == entries_.end()) return false;
    places_.remove(id, it->second->info);
    entries_.erase(it);
    return true;
  }
  void clear() noexcept {
    entries_.clear();
    places_.clear();
  }

  bool contains(KeyframeId id) const { return entries_.count(id) != 0; }
  std::size_t size() const noexcept { return entries_.size(); }
  bool empty() const noexcept { return entries_.empty(); }
  /// Different places among the entries. O(1).
  std::size_t places() const noexcept { return places_.size(); }

  /// The key frame's graph, or nothing.
  std::optional<Graph> find(KeyframeId id) const {
    const auto it = entries_.find(id);
    if (it == entries_.end()) return std::nullopt;
    return it->second->graph;
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
    const std::vector<std::pair<KeyframeId, std::shared_ptr<const Entry>>> now(entries_.begin(),
                                                                               entries_.end());
    for (const auto& [id, entry] : now) f(id, entry->info, entry->graph);
  }

  /// The entries most similar to `graph`, best first, ties by id. O(n · similarity).
  std::vector<Candidate> query(const Graph& graph, const QueryOptions& options = {}) const {
    std::vector<Candidate> found;
    const auto key = key_of(graph);
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

 private:
  static constexpr bool precomputed = has_descriptor_v<Similarity, Graph>;
  struct Nothing {};

  auto key_of(const Graph& graph) const {
    if constexpr (precomputed) {
      return similarity_.descriptor(graph);
    } else {
      return &graph;
    }
  }

  template <typename S, bool = precomputed>
  struct KeyOf {
    using type = Nothing;
  };
  template <typename S>
  struct KeyOf<S, true> {
    using type = decltype(std::declval<const S&>().descriptor(std::declval<const Graph&>()));
  };

  struct Entry {
    Graph graph;
    EntryInfo info;
    typename KeyOf<Similarity>::type descriptor;
  };

  std::shared_ptr<const Entry> make_entry(Graph graph, EntryInfo info) const {
    info.validate();
    if constexpr (detail::is_topology_graph_v<Graph>) require_savable(graph);
    auto entry = std::make_shared<Entry>(Entry{std::move(graph), std::move(info), {}});
    if constexpr (precomputed) entry->descriptor = similarity_.descriptor(entry->graph);
    return entry;
  }

  template <typename Key>
  double score_of(const Key& key, const Entry& entry) const {
    if constexpr (precomputed) {
      return similarity_.similarity(key, entry.descriptor);
    } else {
      return similarity_(*key, entry.graph);
    }
  }

  Similarity similarity_;
  std::map<KeyframeId, std::shared_ptr<const Entry>> entries_;  ///< for_each's stay while it walks
  PlaceCount places_;
};

}  // namespace v0
}  // namespace topobag
