// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include <topobag/types/ids.hpp>

namespace topobag {
inline namespace v0 {

/// Which classes may name the same object. Every class is compatible with itself; further pairs
/// (tv/laptop, bottle/cup) are the user's to add.
class ClassCompatibility {
 public:
  /// Lets `a` and `b` match each other, both ways.
  void allow(ClassId a, ClassId b) {
    const auto pair = std::minmax(a, b);
    const auto at =
        std::lower_bound(pairs_.begin(), pairs_.end(), std::pair<ClassId, ClassId>(pair));
    if (at == pairs_.end() || *at != std::pair<ClassId, ClassId>(pair)) pairs_.insert(at, pair);
  }

  bool operator()(ClassId a, ClassId b) const {
    if (a == b) return true;
    if (pairs_.empty()) return false;
    return std::binary_search(pairs_.begin(), pairs_.end(),
                              std::pair<ClassId, ClassId>(std::minmax(a, b)));
  }

 private:
  std::vector<std::pair<ClassId, ClassId>> pairs_;  ///< (smaller, larger), sorted
};

}  // namespace v0
}  // namespace topobag
