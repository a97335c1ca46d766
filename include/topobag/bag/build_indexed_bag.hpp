// SPDX-License-Identifier: MIT
#pragma once

#include <utility>

#include <topobag/bag/entry_info.hpp>
#include <topobag/bag/indexed_bag.hpp>
#include <topobag/types/ids.hpp>

namespace topobag {
inline namespace v0 {

/// An indexed bag of all entries of another bag, in the fewest segments.
/// @param source  has `for_each(callable(KeyframeId, EntryInfo, graph))`: a bag or a bag's view
/// Throws as `IndexedBag::add` does. O(n log n).
template <typename Source>
IndexedBag build_indexed_bag(const Source& source, IndexedBag::Similarity similarity = {},
                             ViewSection views = ViewSection::kept) {
  IndexedBag bag(std::move(similarity), views);
  source.for_each([&](KeyframeId id, const EntryInfo& info, const IndexedBag::Graph& graph) {
    bag.add(id, graph, info);
  });
  bag.compact();
  return bag;
}

}  // namespace v0
}  // namespace topobag
