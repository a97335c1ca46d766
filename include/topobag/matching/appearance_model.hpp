// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <vector>

#include <topobag/sensing/color_descriptor.hpp>
#include <topobag/types/appearance.hpp>

namespace topobag {
inline namespace v0 {

/// What one similarity of two descriptors says.
struct AppearanceOdds {
  double similarity = 0.0;  ///< cosine, in [-1, 1]
  double log10_odds = 0.0;  ///< that they are of one object, against two objects of a class
};

/// How much more alike one object looks in two images than two objects of its class do.
///
/// The default is for `ColorDescriptor`, measured in two sequences of one desk (fr1_xyz and
/// fr1_rpy) with exposure and white balance as they are and changed in one of them (× 0.6, × 1.6,
/// ± 20 %). One object: 19,400 pairs of boxes of a class that lie within 0.15 m in the world. Two:
/// in equal parts 8,610 pairs of a class, 0.5 m apart and more, who look more alike than those of
/// two rooms, and 20,845 pairs of different classes, who look less alike. Taken for granted is
/// what no desk shows: see `AppearanceCounts`. Pairs of one match hardly err together where they
/// are false (their correlation is -0.04), so that their odds multiply.
struct AppearanceModel {
  AppearanceKind kind = ColorDescriptor::kind;  ///< that the table is of; others say nothing
  /// By rising similarity, between which the odds run straight; constant beyond its ends. Empty:
  /// appearance says nothing.
  std::vector<AppearanceOdds> table{{0.70, -0.90}, {0.80, -0.70}, {0.87, -0.40}, {0.90, -0.10},
                                    {0.92, 0.15},  {0.94, 0.38},  {0.97, 0.55},  {0.99, 0.70}};

  /// log10 P(similarity | one object) / P(similarity | two objects of a class). 0 where one looks
  /// unknown, or of another kind than the table's. O(length of the table).
  double log10_odds(const Appearance& a, const Appearance& b) const {
    if (table.empty() || !a.known() || a.kind() != kind || b.kind() != kind) return 0.0;
    return log10_odds(cosine_similarity(a, b));
  }

  /// The same of a similarity. Precondition: the table is not empty.
  double log10_odds(double similarity) const {
    const auto above = std::upper_bound(
        table.begin(), table.end(), similarity,
        [](double value, const AppearanceOdds& odds) { return value < odds.similarity; });
    if (above == table.begin()) return table.front().log10_odds;
    if (above == table.end()) return table.back().log10_odds;
    const AppearanceOdds &low = *(above - 1), &high = *above;
    const double share = (similarity - low.similarity) / (high.similarity - low.similarity);
    return low.log10_odds + share * (high.log10_odds - low.log10_odds);
  }
};

}  // namespace v0
}  // namespace topobag
