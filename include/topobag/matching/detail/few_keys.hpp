// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include <topobag/version.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// A map of few keys, in the order in which they came: for a dozen, looking through them takes less
/// time than a tree's memory.
template <typename Key, typename Value>
class FewKeys {
 public:
  FewKeys() { entries_.reserve(12); }

  /// The key's value, which stays where it is until another key is new, and whether this one is.
  /// O(keys).
  std::pair<Value&, bool> insert(const Key& key) {
    const auto at = std::find_if(entries_.begin(), entries_.end(),
                                 [&](const auto& entry) { return entry.first == key; });
    if (at != entries_.end()) return {at->second, false};
    entries_.emplace_back(key, Value{});
    return {entries_.back().second, true};
  }
  Value& operator[](const Key& key) { return insert(key).first; }

  auto begin() const noexcept { return entries_.begin(); }
  auto end() const noexcept { return entries_.end(); }

 private:
  std::vector<std::pair<Key, Value>> entries_;
};

}  // namespace detail
}  // namespace v0
}  // namespace topobag
