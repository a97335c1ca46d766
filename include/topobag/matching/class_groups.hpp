// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <map>
#include <optional>
#include <vector>

#include <topobag/types/class_catalog.hpp>
#include <topobag/types/ids.hpp>

namespace topobag {
inline namespace v0 {

/// Groups of classes that detectors take for one another: a tv for a laptop, a bottle for a cup.
/// Nodes of one group may be one object. Every class is in the group of itself until the user joins
/// two.
class ClassGroups {
 public:
  /// Makes one group of the groups of `a` and `b`. O(classes).
  void join(ClassId a, ClassId b) {
    const ClassId group_a = group(a), group_b = group(b);
    const ClassId joined = std::min(group_a, group_b);
    groups_[a] = groups_[b] = joined;
    for (auto& [label, of_label] : groups_) {
      if (of_label == group_a || of_label == group_b) of_label = joined;
    }
  }

  /// The smallest class of the group that holds `label`. O(log classes).
  ClassId group(ClassId label) const {
    const auto it = groups_.find(label);
    return it == groups_.end() ? label : it->second;
  }

  /// The classes of the group that holds `label`, ascending. O(classes).
  std::vector<ClassId> members(ClassId label) const {
    const ClassId of = group(label);
    std::vector<ClassId> found;
    for (const auto& [other, of_other] : groups_) {
      if (of_other == of) found.push_back(other);
    }
    if (found.empty()) found.push_back(label);
    return found;
  }

  /// Whether the two are of one group.
  bool compatible(ClassId a, ClassId b) const { return a == b || group(a) == group(b); }

 private:
  std::map<ClassId, ClassId> groups_;
};

/// The groups that detectors mix up on nearly every desk: tv and laptop, where the catalog has
/// both.
inline ClassGroups lookalike_classes(const ClassCatalog& catalog) {
  ClassGroups groups;
  const std::optional<ClassId> tv = catalog.find("tv"), laptop = catalog.find("laptop");
  if (tv && laptop) groups.join(*tv, *laptop);
  return groups;
}

}  // namespace v0
}  // namespace topobag
