// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include <topobag/error.hpp>
#include <topobag/matching/appearance_model.hpp>
#include <topobag/sensing/color_descriptor.hpp>
#include <topobag/types/appearance.hpp>

namespace topobag {
inline namespace v0 {

/// What is believed of looks whatever was counted.
struct AppearancePrior {
  double unlike = 0.10;  ///< share of the pairs of one object that look as two: light, cut boxes
  double twins = 0.15;   ///< share of the pairs of two objects that look as one: of one make
  std::size_t min_pairs = 100;  ///< of either, below which nothing is learnt
};

/// How alike one object looks in two images, and two objects of a class: counts by similarity, and
/// the table that they make.
///
///     AppearanceCounts counts(kind);
///     learn_appearance(counts, candidate, query, pose);       // of verified matches
///     learn_other_appearance(counts, here, elsewhere);        // of certain negatives
///     options.chance.appearance = counts.model();
class AppearanceCounts {
 public:
  /// @param kind  the descriptors that count; others are passed over
  explicit AppearanceCounts(AppearanceKind kind = ColorDescriptor::kind) : kind_(kind) {}

  /// Counts two sightings of one object. O(1).
  void add_same(const Appearance& a, const Appearance& b) { add(same_, same_total_, a, b); }
  /// Counts two objects of a class. O(1).
  void add_other(const Appearance& a, const Appearance& b) { add(other_, other_total_, a, b); }

  /// Takes in what was counted elsewhere. Throws InvalidValue for counts of descriptors of another
  /// kind. O(bins).
  AppearanceCounts& operator+=(const AppearanceCounts& other) {
    if (other.kind_ != kind_) {
      throw InvalidValue("counts of two kinds of descriptors do not add up");
    }
    for (std::size_t i = 0; i < bins; ++i) {
      same_[i] += other.same_[i];
      other_[i] += other.other_[i];
    }
    same_total_ += other.same_total_;
    other_total_ += other.other_total_;
    return *this;
  }

  /// The descriptors that count.
  const AppearanceKind& kind() const noexcept { return kind_; }
  /// Pairs of one object that were counted.
  std::size_t same() const noexcept { return same_total_; }
  /// Pairs of two objects that were counted.
  std::size_t other() const noexcept { return other_total_; }

  /// The odds that rise with similarity and fit the counts best (pooled adjacent violators), mixed
  /// with the prior's shares, which bound them. Throws InvalidValue with too few pairs. O(bins).
  AppearanceModel model(const AppearancePrior& prior = {}) const {
    if (std::min(same_total_, other_total_) < prior.min_pairs) {
      throw InvalidValue("appearance is learnt from " + std::to_string(prior.min_pairs) +
                         " pairs of one object and as many of two; there are " +
                         std::to_string(same_total_) + " and " + std::to_string(other_total_));
    }
    AppearanceModel model;
    model.kind = kind_;
    model.table.clear();
    for (const Block& block : rising_blocks()) {
      const double p = block.same / static_cast<double>(same_total_);
      const double q = block.other / static_cast<double>(other_total_);
      const double odds = ((1.0 - prior.unlike) * p + prior.unlike * q) /
                          ((1.0 - prior.twins) * q + prior.twins * p);
      model.table.push_back({(block.low + block.high) / 2.0, std::log10(odds)});
    }
    return model;
  }

 private:
  static constexpr std::size_t bins = 200;  ///< of the cosines from -1 to 1
  using Counts = std::array<std::size_t, bins>;

  /// Neighbouring bins that share their odds.
  struct Block {
    double low, high;    ///< similarity
    double same, other;  ///< pairs
  };

  void add(Counts& counts, std::size_t& total, const Appearance& a, const Appearance& b) {
    if (!a.known() || a.kind() != kind_ || b.kind() != kind_) return;
    const double place = (cosine_similarity(a, b) + 1.0) / 2.0 * static_cast<double>(bins);
    ++counts[static_cast<std::size_t>(std::clamp(place, 0.0, static_cast<double>(bins - 1)))];
    ++total;
  }

  std::vector<Block> rising_blocks() const {
    const auto similarity = [](std::size_t edge) {
      return 2.0 * static_cast<double>(edge) / static_cast<double>(bins) - 1.0;
    };
    std::vector<Block> blocks;
    for (std::size_t i = 0; i < bins; ++i) {
      if (same_[i] + other_[i] == 0) continue;
      blocks.push_back({similarity(i), similarity(i + 1), static_cast<double>(same_[i]),
                        static_cast<double>(other_[i])});
      while (blocks.size() > 1) {
        Block& before = blocks[blocks.size() - 2];
        const Block& last = blocks.back();
        if (before.same * last.other < last.same * before.other) break;
        before = {before.low, last.high, before.same + last.same, before.other + last.other};
        blocks.pop_back();
      }
    }
    return blocks;
  }

  AppearanceKind kind_;
  Counts same_{}, other_{};
  std::size_t same_total_ = 0, other_total_ = 0;
};

}  // namespace v0
}  // namespace topobag
