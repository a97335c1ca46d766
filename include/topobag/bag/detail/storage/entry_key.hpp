// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>
#include <utility>

#include <topobag/bag/entry_info.hpp>
#include <topobag/bag/savable_graph.hpp>
#include <topobag/similarity/similarity.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// Stands where a similarity needs nothing kept.
struct Nothing {
  void clear() noexcept {}
};

/// What a bag keeps of an entry to compare it: a descriptor, its slot in an index, or nothing.
template <typename Similarity, typename Graph, bool = has_descriptor_v<Similarity, Graph>,
          bool = is_jaccard_v<Similarity>>
struct EntryKey {
  using type = Nothing;
};
template <typename Similarity, typename Graph>
struct EntryKey<Similarity, Graph, true, false> {
  using type = descriptor_t<Similarity, Graph>;
};
template <typename Similarity, typename Graph>
struct EntryKey<Similarity, Graph, true, true> {
  using type = std::size_t;
};

/// An entry of a bag in memory.
template <typename Graph, typename Similarity>
struct BagEntry {
  Graph graph;
  EntryInfo info;
  typename EntryKey<Similarity, Graph>::type key;

  /// Without its key. Throws as the bag's `add`.
  static std::shared_ptr<BagEntry> made(Graph graph, EntryInfo info) {
    info.validate();
    if constexpr (is_topology_graph_v<Graph>) require_savable(graph);
    return std::make_shared<BagEntry>(BagEntry{std::move(graph), std::move(info), {}});
  }
};

/// What a query is compared by: its descriptor, or where it is.
template <typename Similarity, typename Graph>
auto query_key(const Similarity& similarity, const Graph& graph) {
  if constexpr (has_descriptor_v<Similarity, Graph>) {
    return similarity.descriptor(graph);
  } else {
    return &graph;
  }
}

/// Of a query with this key and an entry, without an index.
template <typename Similarity, typename Key, typename Graph>
double similarity_to(const Similarity& similarity, const Key& key,
                     const BagEntry<Graph, Similarity>& entry) {
  if constexpr (is_jaccard_v<Similarity>) {
    return similarity.similarity(key, similarity.descriptor(entry.graph));
  } else if constexpr (has_descriptor_v<Similarity, Graph>) {
    return similarity.similarity(key, entry.key);
  } else {
    return similarity(*key, entry.graph);
  }
}

}  // namespace detail
}  // namespace v0
}  // namespace topobag
