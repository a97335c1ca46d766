// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include <topobag/bag/detail/index/bag_parts.hpp>
#include <topobag/bag/detail/index/bag_search.hpp>
#include <topobag/bag/detail/index/image_search.hpp>
#include <topobag/bag/graph_codec.hpp>
#include <topobag/bag/memory_usage.hpp>
#include <topobag/bag/search_result.hpp>
#include <topobag/graph/topology_graph.hpp>
#include <topobag/similarity/class_pair_distance_histogram.hpp>
#include <topobag/types/ids.hpp>

namespace topobag {
inline namespace v0 {

/// An `IndexedBag` as it was at one moment: the handle for readers. Never changes, whatever becomes
/// of the bag, and may be read from any number of threads.
template <typename Similarity_ = ClassPairDistanceHistogram>
class BasicBagView {
 public:
  using Graph = TopologyGraph<double>;
  using Similarity = Similarity_;

  /// For `IndexedBag`, which makes views.
  BasicBagView(std::shared_ptr<const Similarity> similarity, detail::BagParts parts)
      : similarity_(std::move(similarity)), parts_(std::move(parts)) {}

  std::size_t size() const noexcept { return parts_.live; }
  bool empty() const noexcept { return parts_.live == 0; }
  /// Different places among the entries. O(1).
  std::size_t places() const noexcept { return parts_.places; }
  /// The most of them that can hold all of `objects`. O(classes²).
  std::size_t places_holding(const ClassCounts& objects, const ClassGroups& groups = {}) const {
    return parts_.contents->holding(objects, groups, parts_.places);
  }
  /// The one kind of the descriptors in the bag; of length 0 where none carries one.
  AppearanceKind appearance_kind() const noexcept { return parts_.kinds.appearance; }
  /// The one kind of the whole images' descriptors; of length 0 where no entry has one.
  ImageKind image_kind() const noexcept { return parts_.kinds.image; }
  bool contains(KeyframeId id) const { return parts_.find(id).has_value(); }

  /// The key frame's graph as it is stored, or nothing.
  std::optional<Graph> find(KeyframeId id) const {
    const auto place = parts_.find(id);
    if (!place) return std::nullopt;
    return graph_at(*place);
  }

  /// What is known of the key frame beside its graph, or nothing.
  std::optional<EntryInfo> info(KeyframeId id) const {
    const auto place = parts_.find(id);
    if (!place) return std::nullopt;
    return parts_.info(*place);
  }

  /// The least id above this one, which need not be there itself; nothing at the end. O(log n).
  std::optional<KeyframeId> after(KeyframeId id) const { return parts_.next_id(id, true); }
  /// The greatest id below this one, likewise. O(log n).
  std::optional<KeyframeId> before(KeyframeId id) const { return parts_.next_id(id, false); }

  /// The key frames whose cameras stand in the region, by rising id; without a pose they are
  /// nowhere. O(entries of the segments whose cameras are about it).
  std::vector<KeyframeId> within(const MapRegion& region) const { return parts_.within(region); }

  /// The entries most similar to `graph`, best first, ties by id: the same ids and similarities, to
  /// the last bit, as comparing it with every stored graph. Throws as `ImageComparison::validate`.
  std::vector<Candidate> query(const Graph& graph, const QueryOptions& options = {}) const {
    return search(graph, options).candidates;
  }

  /// The same, and how much of the bag it took.
  /// @param max_visited  graphs that are read at most; when they do not suffice, the best of those
  ///                     read are returned, with a bound on the similarities of the others. Which are
  ///                     read depends on the bag and the query alone.
  SearchResult search(const Graph& graph, const QueryOptions& options = {},
                      std::size_t max_visited = std::numeric_limits<std::size_t>::max()) const {
    options.image.validate(parts_.kinds.image);
    if (options.max_results == 0) {
      SearchResult nothing;
      nothing.entries = size();
      return nothing;
    }
    if (options.image.scores()) {
      return detail::ImageSearch<Similarity>(parts_, *similarity_, graph, options, max_visited)
          .run();
    }
    return detail::BagSearch<Similarity>(parts_, *similarity_, graph, options, max_visited).run();
  }

  /// Calls `visit(KeyframeId, const EntryInfo&, const Graph&)` for every entry by rising id;
  /// what becomes of the bag meanwhile changes nothing. O(n log n).
  template <typename Visit>
  void for_each(const Visit& visit) const {
    std::vector<std::pair<KeyframeId, detail::EntryPlace>> places;
    places.reserve(size());
    parts_.for_each(
        [&](detail::EntryPlace place) { places.emplace_back(parts_.entry(place).id, place); });
    std::sort(places.begin(), places.end(),
              [](const auto& l, const auto& r) { return l.first < r.first; });
    for (const auto& [id, place] : places) visit(id, parts_.info(place), graph_at(place));
  }

  /// Bytes of what this view holds; much of it may be shared with others. O(n).
  MemoryUsage memory_usage() const {
    MemoryUsage usage;
    for (const detail::SealedPart& part : *parts_.sealed) {
      usage.graphs += part.segment->graph_bytes();
      usage.index += part.segment->index_bytes();
      usage.entries +=
          part.segment->entry_bytes() + part.infos->bytes() + (part.dead ? part.dead->bytes() : 0);
    }
    for (std::size_t slot = 0; slot < parts_.head_size; ++slot) {
      usage.graphs += (*parts_.head)[slot].graph.capacity();
      usage.entries += (*parts_.head)[slot].info.image.kind().length();
    }
    parts_.for_each([&](detail::EntryPlace place) {
      usage.nodes += detail::node_count(parts_.entry(place).graph);
    });
    if (parts_.head) {
      usage.entries += detail::HeadBlock::capacity * sizeof(detail::HeadBlock::Entry);
    }
    usage.entries += sizeof(*this) + parts_.sealed->capacity() * sizeof(detail::SealedPart);
    return usage;
  }

  /// By which entries are compared.
  const Similarity& similarity() const noexcept { return *similarity_; }

 private:
  template <typename>
  friend class BasicIndexedBag;

  Graph graph_at(detail::EntryPlace place) const {
    const detail::StoredEntry entry = parts_.entry(place);
    return decode<double>(entry.graph, entry.graph_size);
  }

  std::shared_ptr<const Similarity> similarity_;
  detail::BagParts parts_;
};

/// The view of an `IndexedBag`.
using BagView = BasicBagView<>;

#ifdef TOPOBAG_COMPILED  // in the library topobag::compiled
extern template class BasicBagView<ClassPairDistanceHistogram>;
#endif

}  // namespace v0
}  // namespace topobag
