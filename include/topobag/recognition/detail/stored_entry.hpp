// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include <topobag/bag/entry_info.hpp>
#include <topobag/types/ids.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// The key frame's graph, to be dereferenced if it is there: read where it is by a bag that keeps
/// it as it is, else as `find` makes it.
template <typename Bag>
auto stored_graph(const Bag& bag, KeyframeId id, int) -> decltype(bag.peek(id)) {
  return bag.peek(id);
}
template <typename Bag>
std::optional<typename Bag::Graph> stored_graph(const Bag& bag, KeyframeId id, long) {
  return bag.find(id);
}

/// What the bag knows of the key frame beside its graph; nothing when the bag has no such call.
template <typename Bag>
auto stored_info(const Bag& bag, KeyframeId id, int) -> decltype(bag.info(id)) {
  return bag.info(id);
}
template <typename Bag>
std::optional<EntryInfo> stored_info(const Bag&, KeyframeId, long) {
  return std::nullopt;
}

}  // namespace detail
}  // namespace v0
}  // namespace topobag
