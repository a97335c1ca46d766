// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <map>
#include <utility>

#include <topobag/error.hpp>
#include <topobag/types/ids.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

inline KeyframeId id_of(KeyframeId id) noexcept { return id; }
template <typename Entry>
KeyframeId id_of(const std::pair<const KeyframeId, Entry>& entry) noexcept {
  return entry.first;
}

/// The ids under which the entries of `theirs` join `ours`: their own where these are free, else
/// those after the greatest of both, in their order. Throws InvalidValue when none are left.
/// @tparam Theirs, Ours  sets of ids or maps from ids
template <typename Theirs, typename Ours>
std::map<KeyframeId, KeyframeId> free_ids(const Theirs& theirs, const Ours& ours) {
  std::uint64_t greatest = 0;
  if (!ours.empty()) greatest = value(id_of(*ours.rbegin()));
  if (!theirs.empty()) greatest = std::max(greatest, value(id_of(*theirs.rbegin())));
  std::map<KeyframeId, KeyframeId> new_ids;
  for (const auto& entry : theirs) {
    const KeyframeId id = id_of(entry);
    const bool is_free = ours.find(id) == ours.end();
    if (!is_free && greatest == std::numeric_limits<std::uint64_t>::max()) {
      throw InvalidValue("no ids are left after the greatest: give the key frames lower ones");
    }
    new_ids.emplace(id, is_free ? id : KeyframeId{++greatest});
  }
  return new_ids;
}

}  // namespace detail
}  // namespace v0
}  // namespace topobag
