// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
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

/// What the leaves of a bag have in common with a query at most, to visit the best first.
class LeafOrder {
 public:
  /// @param total  sum of the query's weights
  /// O(Σ over the query's words of the leaves that have them).
  LeafOrder(const BagParts& parts, const CoarseHistogram& query, double total)
      : parts_(*parts.sealed), total_(static_cast<float>(total)) {
    // Sums are 16 bits wide, for speed: words that might not fit count as common with all.
    CoarseHistogram fitting;
    std::uint32_t greatest_sum = 0;
    for (const CoarseEntry& entry : query) {
      if (entry.weight <= max_sum - greatest_sum) {
        greatest_sum += entry.weight;
        fitting.push_back(entry);
      } else {
        surplus_ += static_cast<float>(entry.weight) / static_cast<float>(coarse_steps);
      }
    }
    std::size_t leaves = 0;
    for (const SealedPart& part : parts_) {
      begins_.push_back(leaves);
      leaves += part.segment->leaves();
    }
    begins_.push_back(leaves);
    sums_.resize(leaves, 0);
    for (std::size_t part = 0; part < parts_.size(); ++part) {
      parts_[part].segment->bounds().add_common(fitting, sums_.data() + begins_[part]);
    }
  }

  /// The leaf of each part that has most in common.
  std::vector<BoundedLeaf> first_of_each_part() const {
    std::vector<BoundedLeaf> first;
    for (std::size_t part = 0; part < parts_.size(); ++part) {
      const auto begin = sums_.begin() + static_cast<std::ptrdiff_t>(begins_[part]);
      const auto end = sums_.begin() + static_cast<std::ptrdiff_t>(begins_[part + 1]);
      first.push_back(at(part, static_cast<std::size_t>(std::max_element(begin, end) - begin)));
    }
    return first;
  }

  /// Those whose bound reaches `floor` >= 0, best first.
  std::vector<BoundedLeaf> at_least(float floor) const {
    // Whatever the graph, its score is no more than what is common over the query's total.
    const float least = (floor * total_ - surplus_) * static_cast<float>(coarse_steps);
    const auto least_sum = static_cast<std::uint32_t>(std::max(0.0F, std::floor(least) - 1.0F));
    std::vector<BoundedLeaf> leaves;
    for (std::size_t part = 0; part < parts_.size(); ++part) {
      for (std::size_t i = begins_[part]; i < begins_[part + 1]; ++i) {
        if (sums_[i] < least_sum) continue;
        const BoundedLeaf leaf = at(part, i - begins_[part]);
        if (leaf.bound >= floor) leaves.push_back(leaf);
      }
    }
    std::sort(leaves.begin(), leaves.end(), [](const BoundedLeaf& l, const BoundedLeaf& r) {
      if (l.bound != r.bound) return l.bound > r.bound;
      return l.part != r.part ? l.part < r.part : l.leaf < r.leaf;
    });
    return leaves;
  }

 private:
  static constexpr std::uint32_t max_sum = 65535;

  BoundedLeaf at(std::size_t part, std::size_t leaf) const {
    const Segment& segment = *parts_[part].segment;
    const float common =
        static_cast<float>(sums_[begins_[part] + leaf]) / static_cast<float>(coarse_steps) +
        surplus_;
    return {jaccard_bound(common, total_, segment.least_totals()[leaf],
                          segment.greatest_totals()[leaf]),
            common, static_cast<std::uint32_t>(part), static_cast<std::uint32_t>(leaf)};
  }

  const BagParts::Sealed& parts_;
  float total_;
  float surplus_ = 0.0F;             ///< weights of the words that are not in the sums
  std::vector<std::size_t> begins_;  ///< of the parts' leaves, and the end
  std::vector<std::uint16_t> sums_;  ///< by leaf, in units of `coarse_steps`
};

}  // namespace detail
}  // namespace v0
}  // namespace topobag
