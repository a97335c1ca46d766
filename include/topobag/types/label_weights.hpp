// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <topobag/error.hpp>
#include <topobag/types/ids.hpp>

namespace topobag {
inline namespace v0 {

/// One of the classes that an object may be of, and how much speaks for it.
struct WeightedLabel {
  ClassId label{};      ///< the class
  double weight = 0.0;  ///< not negative, of any scale: a probability, a score

  friend bool operator==(const WeightedLabel& a, const WeightedLabel& b) noexcept {
    return a.label == b.label && a.weight == b.weight;
  }
};

/// The few classes that an object may be of, best first: what a detector says beside its answer. A
/// byte a class; none where the detector is sure, or says no more than its answer.
class LabelWeights {
 public:
  static constexpr std::size_t max_size = 5;  ///< classes that are kept

  /// None.
  LabelWeights() = default;

  /// @param labels  in any order; one that comes twice is added up. The best five stay, each within
  ///                1/510 of the best one's weight; none where that leaves a single one
  /// Throws InvalidValue, with its index, for a weight that is negative or not finite.
  explicit LabelWeights(const std::vector<WeightedLabel>& labels) {
    std::map<ClassId, double> sums;
    for (std::size_t i = 0; i < labels.size(); ++i) {
      if (!(labels[i].weight >= 0.0) || !std::isfinite(labels[i].weight)) {
        throw InvalidValue(
            "label " + std::to_string(i) + " has a weight that is no number from 0 on", i);
      }
      sums[labels[i].label] += labels[i].weight;
    }
    double greatest = 0.0;
    for (const auto& [label, weight] : sums) greatest = std::max(greatest, weight);
    std::vector<std::pair<int, ClassId>> ranked;  // by falling weight, then rising class
    for (const auto& [label, weight] : sums) {
      if (!(weight > 0.0)) continue;
      ranked.emplace_back(-static_cast<int>(std::lround(weight / greatest * 255.0)), label);
    }
    std::sort(ranked.begin(), ranked.end());
    if (ranked.size() < 2 || ranked[1].first == 0) return;
    for (const auto& [negative, label] : ranked) {
      if (negative == 0 || size_ == max_size) break;
      labels_[size_] = label;
      bytes_[size_++] = static_cast<std::uint8_t>(-negative);
    }
  }

  /// Classes that are kept: 0, or 2 to 5.
  std::size_t size() const noexcept { return size_; }
  bool empty() const noexcept { return size_ == 0; }
  /// The best first, ties by class. Precondition: i < size().
  ClassId label(std::size_t i) const noexcept { return labels_[i]; }
  /// Its weight; the best one's is 255.
  std::uint8_t byte(std::size_t i) const noexcept { return bytes_[i]; }

  friend bool operator==(const LabelWeights& a, const LabelWeights& b) noexcept {
    return a.size_ == b.size_ && a.labels_ == b.labels_ && a.bytes_ == b.bytes_;
  }
  friend bool operator!=(const LabelWeights& a, const LabelWeights& b) noexcept {
    return !(a == b);
  }

 private:
  std::array<ClassId, max_size> labels_{};
  std::array<std::uint8_t, max_size> bytes_{};
  std::uint8_t size_ = 0;
};

/// Whether weights may stand beside a label: there are none, or no class has more than it.
inline bool has_best_label(ClassId label, const LabelWeights& weights) noexcept {
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if (weights.label(i) == label) return weights.byte(i) == weights.byte(0);
  }
  return weights.empty();
}

}  // namespace v0
}  // namespace topobag
