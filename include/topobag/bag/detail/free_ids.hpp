// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <map>

#include <topobag/bag/detail/bag_parts.hpp>
#include <topobag/error.hpp>
#include <topobag/types/ids.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// The ids under which the entries of `theirs` join `ours`: their own where these are free, else those
/// after the greatest of both. Throws InvalidValue when none are left.
inline std::map<KeyframeId, KeyframeId> free_ids(const BagParts& ours, const BagParts& theirs) {
  std::map<KeyframeId, KeyframeId> new_ids;
  std::uint64_t greatest = 0;
  ours.for_each([&](EntryPlace place) {
    greatest = std::max(greatest, value(ours.entry(place).id));
  });
  theirs.for_each([&](EntryPlace place) {
    const KeyframeId id = theirs.entry(place).id;
    greatest = std::max(greatest, value(id));
    new_ids.emplace(id, id);
  });
  for (auto& [id, new_id] : new_ids) {
    if (!ours.find(id)) continue;
    if (greatest == std::numeric_limits<std::uint64_t>::max()) {
      throw InvalidValue("no ids are left after the greatest: give the key frames lower ones");
    }
    new_id = KeyframeId{++greatest};
  }
  return new_ids;
}

}  // namespace detail
}  // namespace v0
}  // namespace topobag
