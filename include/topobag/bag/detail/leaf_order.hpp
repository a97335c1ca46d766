// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <topobag/bag/detail/bag_parts.hpp>
#include <topobag/bag/detail/leaf_bounds.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// The greatest Jaccard index of histograms with sums `a` and `b`, where b lies between `least` and
/// `greatest` and their Σ min is at most `common`.
inline float jaccard_bound(float common, float a, float least, float greatest) noexcept {
  const float b = std::min(std::max(common, least), greatest);
  const float shared = std::min(common, b);
  const float all = a + b - shared;
  return all > 0.0F ? std::min(shared / all, 1.0F) : 0.0F;
}

/// A leaf, and what its graphs can score at most.
struct BoundedLeaf {
  float bound = 0.0F;
  float common = 0.0F;  ///< bound of Σ min
  std::uint32_t part = 0;
  std::uint32_t leaf = 0;
};

/// Bounds of all leaves of a bag for one query, to visit the best first.
class LeafOrder {
 public:
  /// O(Σ over the query's words of the leaves that have them).
  /// @param total   sum of the query's weights
  LeafOrder(const BagParts& parts, const CoarseHistogram& query, double total)
      : total_(static_cast<float>(total)) {
    std::uint64_t greatest_sum = 0;
    for (const CoarseEntry& entry : query) greatest_sum += entry.weight;
    if (greatest_sum < 65536) {
      fill<std::uint16_t>(parts, query);
    } else {
      fill<std::uint64_t>(parts, query);
    }
  }

  /// The best leaf of each part, which is then no longer among the others.
  std::vector<BoundedLeaf> take_best_of_each_part() {
    std::vector<BoundedLeaf> best;
    for (std::uint32_t part = 0; part + 1 < begins_.size(); ++part) {
      const auto begin = bounds_.begin() + static_cast<std::ptrdiff_t>(begins_[part]);
      const auto end = bounds_.begin() + static_cast<std::ptrdiff_t>(begins_[part + 1]);
      if (begin == end) continue;
      const auto leaf = std::max_element(begin, end);
      best.push_back(at(part, static_cast<std::size_t>(leaf - begin)));
      *leaf = taken;
    }
    return best;
  }

  /// Those that reach `floor` >= 0, best first.
  std::vector<BoundedLeaf> at_least(float floor) const {
    std::vector<BoundedLeaf> leaves;
    for (std::uint32_t part = 0; part + 1 < begins_.size(); ++part) {
      for (std::size_t i = begins_[part]; i < begins_[part + 1]; ++i) {
        if (bounds_[i] >= floor) leaves.push_back(at(part, i - begins_[part]));
      }
    }
    std::sort(leaves.begin(), leaves.end(), [](const BoundedLeaf& l, const BoundedLeaf& r) {
      if (l.bound != r.bound) return l.bound > r.bound;
      return l.part != r.part ? l.part < r.part : l.leaf < r.leaf;
    });
    return leaves;
  }

 private:
  static constexpr float taken = -1.0F;

  BoundedLeaf at(std::uint32_t part, std::size_t leaf) const {
    const std::size_t i = begins_[part] + leaf;
    return {bounds_[i], common_[i], part, static_cast<std::uint32_t>(leaf)};
  }

  template <typename Sum>
  void fill(const BagParts& parts, const CoarseHistogram& query) {
    std::size_t leaves = 0;
    for (const SealedPart& part : *parts.sealed) {
      begins_.push_back(leaves);
      leaves += part.segment->leaves();
    }
    begins_.push_back(leaves);
    bounds_.resize(leaves);
    common_.resize(leaves);
    std::vector<Sum> sums;
    for (std::size_t part = 0; part < parts.sealed->size(); ++part) {
      const Segment& segment = *(*parts.sealed)[part].segment;
      sums.assign(segment.leaves(), 0);
      segment.bounds().add_common(query, sums.data());
      float* bounds = bounds_.data() + begins_[part];
      float* common = common_.data() + begins_[part];
      const float* least = segment.least_totals().data();
      const float* greatest = segment.greatest_totals().data();
      for (std::size_t leaf = 0; leaf < sums.size(); ++leaf) {
        common[leaf] = static_cast<float>(sums[leaf]) / static_cast<float>(coarse_steps);
        bounds[leaf] = jaccard_bound(common[leaf], total_, least[leaf], greatest[leaf]);
      }
    }
  }

  float total_;
  std::vector<std::size_t> begins_;  ///< of the parts' leaves, and the end
  std::vector<float> bounds_, common_;
};

}  // namespace detail
}  // namespace v0
}  // namespace topobag
