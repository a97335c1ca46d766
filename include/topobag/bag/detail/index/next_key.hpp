// SPDX-License-Identifier: MIT
#pragma once

#include <iterator>
#include <optional>

#include <topobag/version.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// The least key of a `std::map` above this one, which need not be there; nothing at the end.
/// O(log n).
template <typename Map>
std::optional<typename Map::key_type> key_after(const Map& map, typename Map::key_type key) {
  const auto it = map.upper_bound(key);
  if (it == map.end()) return std::nullopt;
  return it->first;
}

/// The greatest below it.
template <typename Map>
std::optional<typename Map::key_type> key_before(const Map& map, typename Map::key_type key) {
  const auto it = map.lower_bound(key);
  if (it == map.begin()) return std::nullopt;
  return std::prev(it)->first;
}

}  // namespace detail
}  // namespace v0
}  // namespace topobag
