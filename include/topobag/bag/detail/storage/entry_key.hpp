// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>
#include <utility>

#include <topobag/bag/entry_info.hpp>
#include <topobag/bag/savable_graph.hpp>
#include <topobag/similarity/similarity.hpp>
#include <topobag/types/appearance.hpp>

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

/// The one kind of descriptors that a bag has with a graph's; unknown for a graph that is not
/// topobag's. Throws InvalidValue when they are of two kinds.
template <typename Graph>
AppearanceKind kind_with([[maybe_unused]] const AppearanceKind& known,
                         [[maybe_unused]] const Graph& graph) {
  if constexpr (is_topology_graph_v<Graph>) {
    return common_kind(known, graph.appearance_kind(), "the key frame");
  } else {
    return {};
  }
}

}  // namespace detail
}  // namespace v0
}  // namespace topobag
