// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include <topobag/bag/detail/coarse_histogram.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// A histogram thrown into few buckets, a byte each, rounded up: as long as a cache line. Σ min of
/// two sketches is at least that of the histograms.
class Sketch {
 public:
  Sketch() = default;
  explicit Sketch(const CoarseHistogram& histogram) {
    const Sums sums = bucket_sums(histogram);
    for (std::size_t i = 0; i < buckets; ++i) {
      bytes_[i] = static_cast<std::uint8_t>(std::min(sums[i], full));
    }
  }

 private:
  friend class SketchQuery;
  static constexpr std::size_t buckets = 64;
  static constexpr std::uint64_t full = 255;
  static constexpr std::uint64_t steps = 32;  ///< of a weight of 1
  using Sums = std::array<std::uint64_t, buckets>;

  static Sums bucket_sums(const CoarseHistogram& histogram) {
    Sums sums{};
    for (const CoarseEntry& entry : histogram) sums[entry.word % buckets] += entry.weight;
    constexpr std::uint64_t ratio = static_cast<std::uint64_t>(coarse_steps) / steps;
    for (std::uint64_t& sum : sums) sum = (sum + ratio - 1) / ratio;
    return sums;
  }

  std::array<std::uint8_t, buckets> bytes_{};
};

/// A query's histogram, to bound its Σ min with those of graphs by their sketches.
class SketchQuery {
 public:
  explicit SketchQuery(const CoarseHistogram& histogram) : sketch_(histogram) {
    for (const std::uint64_t sum : Sketch::bucket_sums(histogram)) {
      beyond_ += sum - std::min(sum, Sketch::full);
    }
  }

  float common(const Sketch& other) const noexcept {
    std::uint16_t sum = 0;  // as narrow as holds it: more at a time
    for (std::size_t i = 0; i < Sketch::buckets; ++i) {
      sum = static_cast<std::uint16_t>(sum + std::min(sketch_.bytes_[i], other.bytes_[i]));
    }
    // What does not fit into the query's bytes may be there in full.
    return static_cast<float>(sum + beyond_) / static_cast<float>(Sketch::steps);
  }

 private:
  Sketch sketch_;
  std::uint64_t beyond_ = 0;
};

}  // namespace detail
}  // namespace v0
}  // namespace topobag
