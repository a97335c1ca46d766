// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

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

}  // namespace detail
}  // namespace v0
}  // namespace topobag
