// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <topobag/bag/detail/index/bag_parts.hpp>
#include <topobag/bag/detail/index/leaf_bounds.hpp>

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

/// What the leaves of a bag have in common with a query at most, to visit the best first. Gives
/// each leaf once.
template <typename Parts>
class LeafOrder {
 public:
  /// @param total  sum of the query's weights
  /// O(Σ over the query's words of the leaves that have them).
  LeafOrder(const Parts& parts, const CoarseHistogram& query, double total)
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
    given_.resize(leaves, false);
    for (std::size_t part = 0; part < parts_.size(); ++part) {
      parts_[part].segment->bounds().add_common(fitting, sums_.data() + begins_[part]);
      add_stretches(part);
    }
  }

  /// The leaf that has most in common, of each of the `count` best stretches of neighbours; best
  /// first.
  std::vector<BoundedLeaf> take_best(std::size_t count) {
    std::vector<Stretch> best(std::min(count, stretches_.size()));
    std::partial_sort_copy(stretches_.begin(), stretches_.end(), best.begin(), best.end(),
                           [](const Stretch& l, const Stretch& r) {
                             return l.greatest != r.greatest ? l.greatest > r.greatest
                                                             : l.begin < r.begin;
                           });
    std::vector<BoundedLeaf> leaves;
    for (const Stretch& stretch : best) {
      std::size_t i = stretch.begin;
      while (sums_[i] != stretch.greatest) ++i;
      take(i, stretch.part, 0.0F, leaves);
    }
    return sorted(std::move(leaves));
  }

  /// Those whose bound reaches `floor` >= 0, best first.
  std::vector<BoundedLeaf> take_at_least(float floor) {
    // By c / (total + t - c) >= floor, a leaf with totals t has to have c >= scale * (total + t) in
    // common: in whole numbers, with a little less asked for the rounding.
    const float scale = std::max(0.0F, floor - 1e-5F) / (1.0F + floor);
    const float least = (scale * total_ - surplus_) * static_cast<float>(coarse_steps) - 2.0F;
    const auto offset = static_cast<std::int32_t>(std::clamp(least, -1e9F, 1e9F));
    const auto slope = static_cast<std::uint32_t>(scale * 65536.0F);
    std::array<bool, Stretch::length> reach{};
    std::vector<BoundedLeaf> leaves;
    for (const Stretch& stretch : stretches_) {
      if (stretch.greatest < offset) continue;
      const std::uint16_t* sums = sums_.data() + stretch.begin;
      const std::uint16_t* totals =
          parts_[stretch.part].segment->least_totals() + (stretch.begin - begins_[stretch.part]);
      const std::size_t size = stretch.end - stretch.begin;
      for (std::size_t i = 0; i < size; ++i) {
        reach[i] = sums[i] >= offset + static_cast<std::int32_t>(slope * totals[i] >> 16U);
      }
      for (std::size_t i = 0; i < size; ++i) {
        if (reach[i]) take(stretch.begin + i, stretch.part, floor, leaves);
      }
    }
    return sorted(std::move(leaves));
  }

 private:
  static constexpr std::uint32_t max_sum = 65535;

  /// Some neighbouring leaves of a part, to pass over those of which none is good enough.
  struct Stretch {
    static constexpr std::size_t length = 64;
    std::size_t part = 0, begin = 0, end = 0;
    std::uint16_t greatest = 0;  ///< of the sums
  };

  void add_stretches(std::size_t part) {
    for (std::size_t begin = begins_[part]; begin < begins_[part + 1]; begin += Stretch::length) {
      Stretch stretch{part, begin, std::min(begin + Stretch::length, begins_[part + 1]), 0};
      for (std::size_t i = begin; i < stretch.end; ++i) {
        stretch.greatest = std::max(stretch.greatest, sums_[i]);
      }
      stretches_.push_back(stretch);
    }
  }

  void take(std::size_t i, std::size_t part, float floor, std::vector<BoundedLeaf>& leaves) {
    if (given_[i]) return;
    const Segment& segment = *parts_[part].segment;
    const std::size_t leaf = i - begins_[part];
    const float common = static_cast<float>(sums_[i]) / static_cast<float>(coarse_steps) + surplus_;
    const auto [least, greatest] = segment.total_range(leaf);
    const float bound = jaccard_bound(common, total_, least, greatest);
    if (bound < floor) return;
    given_[i] = true;
    leaves.push_back(
        {bound, common, static_cast<std::uint32_t>(part), static_cast<std::uint32_t>(leaf)});
  }

  static std::vector<BoundedLeaf> sorted(std::vector<BoundedLeaf> leaves) {
    std::sort(leaves.begin(), leaves.end(), [](const BoundedLeaf& l, const BoundedLeaf& r) {
      if (l.bound != r.bound) return l.bound > r.bound;
      return l.part != r.part ? l.part < r.part : l.leaf < r.leaf;
    });
    return leaves;
  }

  const typename Parts::Sealed& parts_;
  float total_;
  float surplus_ = 0.0F;             ///< weights of the words that are not in the sums
  std::vector<std::size_t> begins_;  ///< of the parts' leaves, and the end
  std::vector<std::uint16_t> sums_;  ///< by leaf, in units of `coarse_steps`
  std::vector<bool> given_;          ///< by leaf
  std::vector<Stretch> stretches_;
};

}  // namespace detail
}  // namespace v0
}  // namespace topobag
