// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <topobag/bag/bag_concepts.hpp>
#include <topobag/bag/camera_poses.hpp>
#include <topobag/bag/detail/index/compare_all.hpp>
#include <topobag/bag/detail/index/entry_places.hpp>
#include <topobag/bag/detail/index/free_ids.hpp>
#include <topobag/bag/detail/index/histogram_index.hpp>
#include <topobag/bag/detail/index/next_key.hpp>
#include <topobag/bag/detail/storage/descriptor_kinds.hpp>
#include <topobag/bag/detail/storage/entry_key.hpp>
#include <topobag/bag/entry_filter.hpp>
#include <topobag/bag/entry_info.hpp>
#include <topobag/bag/merge_options.hpp>
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
/// and a `jaccard` (`is_jaccard_v`) costs no more than what entries share with the query. The order
/// of adding changes no result. Graphs stay as they are given; files round them (`encode`).
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
  /// as `EntryInfo::validate` and, of a `TopologyGraph`, `require_savable` and for descriptors, of
  /// objects or of the image, of another kind than the bag's. O(log n + descriptor).
  void add(KeyframeId id, Graph graph, EntryInfo info = {}) {
    if (contains(id)) {
      throw InvalidId("key frame " + std::to_string(value(id)) +
                      " is in the bag already: use update");
    }
    auto [entry, descriptor] = taken_in(std::move(graph), std::move(info));
    place(id, *entries_.emplace(id, std::move(entry)).first->second, std::move(descriptor));
  }

  /// Replaces a key frame's graph and info. Throws InvalidId if `id` is not there.
  void update(KeyframeId id, Graph graph, EntryInfo info = {}) {
    const auto it = entries_.find(id);
    if (it == entries_.end()) {
      throw InvalidId("key frame " + std::to_string(value(id)) + " is not in the bag: use add");
    }
    auto [entry, descriptor] = taken_in(std::move(graph), std::move(info));
    displace(id, *it->second);
    it->second = std::move(entry);
    place(id, *it->second, std::move(descriptor));
  }

  /// Moves key frames, as a back end does when it has closed a loop; the others stay. Throws as
  /// `require_poses_of`. O(poses · log n): graphs and index are not touched.
  void set_poses(const CameraPoses& T_world_camera) {
    require_poses_of(*this, T_world_camera);
    for (const auto& [id, T] : T_world_camera) {
      EntryPointer& entry = entries_.find(id)->second;
      if (entry.use_count() > 1) entry = std::make_shared<Entry>(*entry);  // for_each keeps the old
      places_.move(id, entry->info, detail::objects_of(entry->graph), T);
    }
  }

  /// Adds all entries of another bag. Ids that are free are kept; the others become the numbers
  /// after the greatest of both bags, in their order. Returns where each id went. Throws as
  /// `MergeOptions` and `add`, and InvalidValue when the ids run out. O(n · add).
  /// @param other  with `for_each` as this one's
  template <typename Other>
  std::map<KeyframeId, KeyframeId> merge(const Other& other, const MergeOptions& options = {}) {
    static_assert(detail::require_entries<Other, Graph>());
    options.validate();
    detail::DescriptorKinds kinds = kinds_;
    using Descriptor = decltype(descriptor_of(std::declval<const Graph&>()));
    std::map<KeyframeId, std::pair<EntryPointer, Descriptor>> joining;
    other.for_each([&](KeyframeId id, const EntryInfo& info, const Graph& given) {
      kinds = kinds.with(given, info);
      const auto graph = options.in_this_unit(given);
      joining.emplace(
          id, std::make_pair(Entry::made(*graph, options.moved(info)), descriptor_of(*graph)));
    });
    const auto new_ids = detail::free_ids(joining, entries_);
    kinds_ = kinds;
    for (auto& [id, joined] : joining) {
      const KeyframeId new_id = new_ids.at(id);
      place(new_id, *entries_.emplace(new_id, std::move(joined.first)).first->second,
            std::move(joined.second));
    }
    return new_ids;
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
    index_.clear();
    kinds_ = {};
  }

  bool contains(KeyframeId id) const { return entries_.count(id) != 0; }
  std::size_t size() const noexcept { return entries_.size(); }
  bool empty() const noexcept { return entries_.empty(); }
  /// Different places among the entries. O(1).
  std::size_t places() const noexcept { return places_.count().size(); }
  /// The most of them that can hold all of `objects`. O(classes²).
  std::size_t places_holding(const ClassCounts& objects, const ClassGroups& groups = {}) const {
    return places_.count().contents().holding(objects, groups, places());
  }
  /// The one kind of the descriptors that were added; of length 0 where none was.
  AppearanceKind appearance_kind() const noexcept { return kinds_.appearance; }
  /// The same of the whole images' descriptors.
  ImageKind image_kind() const noexcept { return kinds_.image; }

  /// The key frame's graph, or nothing.
  std::optional<Graph> find(KeyframeId id) const {
    const Graph* const graph = peek(id);
    return graph != nullptr ? std::optional<Graph>(*graph) : std::nullopt;
  }
  /// The same where it is, or null; until the entry is changed or taken out.
  const Graph* peek(KeyframeId id) const {
    const auto it = entries_.find(id);
    return it == entries_.end() ? nullptr : &it->second->graph;
  }

  /// What is known of the key frame beside its graph, or nothing.
  std::optional<EntryInfo> info(KeyframeId id) const {
    const auto it = entries_.find(id);
    return it == entries_.end() ? std::nullopt : std::optional(it->second->info);
  }
  /// The id next to this one, which need not be there itself; nothing at the end. O(log n).
  std::optional<KeyframeId> after(KeyframeId id) const { return detail::key_after(entries_, id); }
  std::optional<KeyframeId> before(KeyframeId id) const { return detail::key_before(entries_, id); }

  /// Calls f(KeyframeId, const EntryInfo&, const Graph&) for every entry that is there when the
  /// call begins, by rising id; f may change the bag. O(n).
  template <typename F>
  void for_each(F&& f) const {
    const std::vector<std::pair<KeyframeId, EntryPointer>> now(entries_.begin(), entries_.end());
    for (const auto& [id, entry] : now) f(id, entry->info, entry->graph);
  }

  /// The key frames whose cameras stand in the region, by rising id; without a pose they are
  /// nowhere. O(log n · rows of 3 m cells that it meets + key frames in these).
  std::vector<KeyframeId> within(const MapRegion& region) const {
    return places_.cameras().within(region);
  }

  /// The entries most similar to `graph`, best first, ties by id. O(n · similarity). An options'
  /// `filter` need not be asked of an entry that is not among the best anyway. Throws as
  /// `ImageComparison::validate`.
  std::vector<Candidate> query(const Graph& graph, const QueryOptions& options = {}) const {
    options.image.validate(kinds_.image);
    const auto key = detail::query_key(similarity_, graph);
    if constexpr (indexed) {
      const bool restricts = options.restricts();
      const auto admits = [&](KeyframeId id) {
        return !restricts || options.admits(id, entries_.find(id)->second->info);
      };
      if (!options.image.scores()) return index_.query(key, options, admits);
    }
    return detail::compare_all(entries_, options, [&](const Entry& entry) {
      return options.image.score(detail::similarity_to(similarity_, key, entry), entry.info.image);
    });
  }

 private:
  static constexpr bool precomputed = has_descriptor_v<Similarity, Graph>;
  static constexpr bool indexed = is_jaccard_v<Similarity>;

  using Entry = detail::BagEntry<Graph, Similarity>;
  using EntryPointer = std::shared_ptr<Entry>;  ///< for_each's stay while it walks

  auto descriptor_of([[maybe_unused]] const Graph& graph) const {
    if constexpr (precomputed) {
      return similarity_.descriptor(graph);
    } else {
      return detail::Nothing{};
    }
  }

  /// The entry and its descriptor, and that what its objects look like is of the bag's kind from
  /// now on. What may throw comes first.
  auto taken_in(Graph graph, EntryInfo info) {
    const detail::DescriptorKinds kinds = kinds_.with(graph, info);
    auto entry = Entry::made(std::move(graph), std::move(info));
    auto descriptor = descriptor_of(entry->graph);
    kinds_ = kinds;
    return std::make_pair(std::move(entry), std::move(descriptor));
  }

  /// Makes an entry known to everything that finds entries.
  template <typename Descriptor>
  void place(KeyframeId id, Entry& entry, [[maybe_unused]] Descriptor descriptor) {
    places_.add(id, entry.info, detail::objects_of(entry.graph));
    if constexpr (indexed) {
      entry.key = index_.add(id, descriptor);
    } else if constexpr (precomputed) {
      entry.key = std::move(descriptor);
    }
  }
  void displace(KeyframeId id, const Entry& entry) {
    places_.remove(id, entry.info, detail::objects_of(entry.graph));
    if constexpr (indexed) index_.remove(entry.key, similarity_.descriptor(entry.graph));
  }

  Similarity similarity_;
  std::map<KeyframeId, EntryPointer> entries_;
  detail::EntryPlaces places_;
  detail::DescriptorKinds kinds_;
  std::conditional_t<indexed, detail::HistogramIndex, detail::Nothing> index_;
};

#ifdef TOPOBAG_COMPILED  // in the library topobag::compiled
extern template class BagOfTopologyGraphs<TopologyGraph<double>, ClassPairDistanceHistogram>;
#endif

}  // namespace v0
}  // namespace topobag
