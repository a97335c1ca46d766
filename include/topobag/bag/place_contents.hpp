// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <map>
#include <utility>
#include <vector>

#include <topobag/matching/class_groups.hpp>
#include <topobag/types/ids.hpp>

namespace topobag {
inline namespace v0 {

/// Objects by class: how many of each.
using ClassCounts = std::map<ClassId, std::size_t>;

/// The nodes that have a position, by class. O(n log classes).
template <typename Nodes>
ClassCounts class_counts(const Nodes& nodes) {
  ClassCounts counts;
  for (const auto& node : nodes) {
    if (node.position) ++counts[node.label];
  }
  return counts;
}

/// In how many places of a map one finds objects of given classes: what the map repeats of itself.
///
/// Kept are the places that hold so many objects of a class, and those that hold two classes at
/// once. Room for O(class pairs that share a place), whatever the number of places.
class PlaceContents {
 public:
  /// A place holds `count` objects of a class now, one more than before. O(classes).
  void add(ClassId label, std::size_t count) { change({{label, label}, count}, 1); }
  /// A place holds both classes now, and did not before. O(class pairs).
  void add(ClassId a, ClassId b) { change({std::minmax(a, b), 1}, 1); }

  /// Undoes the same. Precondition: it was added.
  void remove(ClassId label, std::size_t count) { change({{label, label}, count}, -1); }
  /// Undoes that of two classes.
  void remove(ClassId a, ClassId b) { change({std::minmax(a, b), 1}, -1); }

  void clear() noexcept {
    places_.clear();
    ++revision_;
  }

  /// Another number after every change.
  std::uint64_t revision() const noexcept { return revision_; }

  /// The most places that can hold all of `objects`, by the rarest of them and the rarest pair of
  /// two; an object of another class of its group will do. At least 1. O(k² · members² · log class
  /// pairs) for k classes.
  /// @param of  places there are
  std::size_t holding(const ClassCounts& objects, const ClassGroups& groups, std::size_t of) const {
    ClassCounts by_group;
    for (const auto& [label, count] : objects) by_group[groups.group(label)] += count;
    std::size_t most = of;
    for (auto a = by_group.begin(); a != by_group.end(); ++a) {
      const std::vector<ClassId> here = members(a->first, groups);
      most = std::min(most, any(here, here.size() == 1 ? a->second : 1));
      for (auto b = std::next(a); b != by_group.end(); ++b) {
        most = std::min(most, any(here, members(b->first, groups)));
      }
    }
    return std::max<std::size_t>(most, 1);
  }

 private:
  /// Two classes, or one twice, and how many of it.
  using Key = std::pair<std::pair<ClassId, ClassId>, std::size_t>;
  using Counted = std::pair<Key, std::size_t>;

  static bool before(const Counted& counted, const Key& key) { return counted.first < key; }

  void change(const Key& key, int by) {
    ++revision_;
    const auto at = std::lower_bound(places_.begin(), places_.end(), key, before);
    if (at == places_.end() || at->first != key) {
      places_.insert(at, {key, 1});
    } else if (by > 0) {
      ++at->second;
    } else if (--at->second == 0) {
      places_.erase(at);
    }
  }

  std::size_t places(const Key& key) const {
    const auto at = std::lower_bound(places_.begin(), places_.end(), key, before);
    return at == places_.end() || at->first != key ? 0 : at->second;
  }

  /// At most so many places hold so many objects of one of the classes.
  std::size_t any(const std::vector<ClassId>& classes, std::size_t count) const {
    std::size_t sum = 0;
    for (const ClassId label : classes) sum += places({{label, label}, count});
    return sum;
  }

  /// At most so many places hold one class of each.
  std::size_t any(const std::vector<ClassId>& a, const std::vector<ClassId>& b) const {
    std::size_t sum = 0;
    for (const ClassId one : a) {
      for (const ClassId other : b) sum += places({std::minmax(one, other), 1});
    }
    return sum;
  }

  /// The classes of the group that the map holds.
  std::vector<ClassId> members(ClassId group, const ClassGroups& groups) const {
    std::vector<ClassId> found = groups.members(group);
    found.erase(std::remove_if(found.begin(), found.end(),
                               [&](ClassId label) { return places({{label, label}, 1}) == 0; }),
                found.end());
    return found;
  }

  std::vector<Counted> places_;  ///< ascending
  std::uint64_t revision_ = 0;
};

}  // namespace v0
}  // namespace topobag
