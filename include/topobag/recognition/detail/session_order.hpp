// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <topobag/bag/entry_info.hpp>
#include <topobag/recognition/detail/stored_entry.hpp>
#include <topobag/types/ids.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// The id above or below, by the bag's own word; of one that does not tell, the next number.
template <typename Bag>
auto next_id(const Bag& bag, KeyframeId id, bool above, int) -> decltype(bag.after(id)) {
  return above ? bag.after(id) : bag.before(id);
}
template <typename Bag>
std::optional<KeyframeId> next_id(const Bag&, KeyframeId id, bool above, long) {
  return KeyframeId{above ? value(id) + 1 : value(id) - 1};
}

/// The key frames of a session that come next after one of it, or before it, by their ids: the
/// nearest first, at most `count`. O(count · log n); others' between them are passed over, as
/// many as two robots' that map at once.
template <typename Bag>
std::vector<KeyframeId> next_of_session(const Bag& bag, KeyframeId id, const EntryInfo& info,
                                        bool above, std::size_t count) {
  const std::size_t most_others = 16;
  std::vector<KeyframeId> next;
  std::size_t others = 0;
  while (next.size() < count && others < count + most_others) {
    const std::optional<KeyframeId> near = next_id(bag, id, above, 0);
    if (!near) break;
    id = *near;
    const auto there = stored_info(bag, id, 0);
    if (there && there->session == info.session) {
      next.push_back(id);
    } else {
      ++others;
    }
  }
  return next;
}

}  // namespace detail
}  // namespace v0
}  // namespace topobag
