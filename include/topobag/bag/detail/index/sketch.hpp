// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include <topobag/bag/detail/index/coarse_histogram.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// A histogram's total, and its weights thrown into few buckets, a byte each, rounded up: together
/// a cache line. Σ min of two sketches is at least that of the histograms.
class alignas(64) Sketch {
 public:
  Sketch() = default;
  /// @param total  the sum of the weights as they were before `histogram` rounded them
  Sketch(const CoarseHistogram& histogram, float total) {
    const Sums sums = bucket_sums(histogram);
    for (std::size_t i = 0; i < buckets; ++i) {
      bytes_[i] = static_cast<std::uint8_t>(std::min(sums[i], full));
    }
    std::memcpy(bytes_.data() + buckets, &total, sizeof(total));
  }

  /// To a float's accuracy.
  float total() const noexcept {
    float total = 0.0F;
    std::memcpy(&total, bytes_.data() + buckets, sizeof(total));
    return total;
  }

 private:
  friend class SketchQuery;
  static constexpr std::size_t size = 64;
  static constexpr std::size_t buckets = size - sizeof(float);
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

  std::array<std::uint8_t, size> bytes_{};
};

/// A query's histogram, to bound its Σ min with those of graphs by their sketches.
class SketchQuery {
 public:
  explicit SketchQuery(const CoarseHistogram& histogram) : sketch_(histogram, 0.0F) {
    for (const std::uint64_t sum : Sketch::bucket_sums(histogram)) {
      beyond_ += sum - std::min(sum, Sketch::full);
    }
  }

  float common(const Sketch& other) const noexcept {
    std::uint16_t sum = 0;  // as narrow as holds it: more at a time
    // With the other's total, of which the query's four zero bytes take nothing: whole vectors.
    for (std::size_t i = 0; i < Sketch::size; ++i) {
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
