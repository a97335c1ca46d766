// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <topobag/similarity/sparse_histogram.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// A word of a histogram, shortened, and a weight in units of 1/128, rounded up. Two words that
/// become the same one only loosen a bound.
struct CoarseEntry {
  std::uint32_t word = 0;
  std::uint32_t weight = 0;

  friend bool operator<(const CoarseEntry& l, const CoarseEntry& r) noexcept {
    return l.word < r.word;
  }
};
using CoarseHistogram = std::vector<CoarseEntry>;  ///< ascending, each word once
inline constexpr double coarse_steps = 128.0;

/// A vote for a word, shortened.
using CoarseVote = std::pair<std::uint32_t, double>;

/// Sums votes, in any order, and rounds up; leaves them sorted. O(m log m).
inline CoarseHistogram coarse_histogram(std::vector<CoarseVote>& votes) {
  std::sort(votes.begin(), votes.end(),
            [](const auto& l, const auto& r) { return l.first < r.first; });
  CoarseHistogram coarse;
  for (std::size_t i = 0; i < votes.size();) {
    const std::uint32_t word = votes[i].first;
    double sum = 0.0;
    for (; i < votes.size() && votes[i].first == word; ++i) sum += votes[i].second;
    // A little more, so that the order of the sum does not matter; then never less than it is.
    const double steps = std::min(std::ceil(sum * coarse_steps + 1e-6), 1e9);
    coarse.push_back({word, static_cast<std::uint32_t>(steps)});
  }
  return coarse;
}

inline CoarseHistogram coarse_histogram(const SparseHistogram& histogram) {
  std::vector<CoarseVote> votes;
  for (const SparseHistogram::Entry& entry : histogram.entries()) {
    votes.emplace_back(static_cast<std::uint32_t>(entry.word), entry.weight);
  }
  return coarse_histogram(votes);
}

}  // namespace detail
}  // namespace v0
}  // namespace topobag
