// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include <topobag/error.hpp>
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
/// The default is for `ColorDescriptor`, measured in one sequence of one desk (fr1_xyz, key frames
/// 4 s apart and more) with exposure and white balance as they are and changed in one of the two (×
/// 0.6, × 1.6, ± 20 %). One object: 36,790 pairs of boxes of a class that lie within 0.15 m in the
/// world. Two: in equal parts 9,460 pairs of a class, 0.5 m apart and more, that look more alike
/// than those of two rooms, and 30,435 pairs of different classes, that look less alike. Taken for
/// granted is what no desk shows: of a pair the shares of `AppearancePrior`, of a whole match the
/// two below.
struct AppearanceModel {
  AppearanceKind kind = ColorDescriptor::kind;  ///< that the table is of; others say nothing
  /// By rising similarity, between which the odds run straight; constant beyond its ends. Empty:
  /// appearance says nothing.
  std::vector<AppearanceOdds> table{{0.70, -0.93},  {0.78, -0.88}, {0.82, -0.72}, {0.855, -0.47},
                                    {0.885, -0.28}, {0.91, -0.10}, {0.93, 0.12},  {0.955, 0.37},
                                    {0.975, 0.53},  {0.99, 0.65}};

  double furnished_alike = 0.03;  ///< share of other places whose objects look the same, all
  double light_changed = 0.03;    ///< share of revisits on which none looks as before

  /// What the pairs of one match say together, whose own log10 odds add up to `sum`: about the sum
  /// where it is small, and no more, nor less, than the two shares allow, for rooms are furnished
  /// from one catalogue, and a lamp shines on all. O(1).
  double log10_odds_together(double sum) const {
    const double odds = std::pow(10.0, std::clamp(sum, -100.0, 100.0));
    return std::log10(((1.0 - light_changed) * odds + light_changed) /
                      (1.0 - furnished_alike + furnished_alike * odds));
  }

  /// log10 P(similarity | one object) / P(similarity | two objects of a class). 0 where one looks
  /// unknown, or of another kind than the table's. O(length of the table).
  double log10_odds(const Appearance& a, const Appearance& b) const {
    return compares(a, b) ? log10_odds(cosine_similarity(a, b)) : 0.0;
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

  /// Whether the table speaks of the two.
  bool compares(const Appearance& a, const Appearance& b) const noexcept {
    return !table.empty() && a.known() && a.kind() == kind && b.kind() == kind;
  }

  /// Throws InvalidValue unless the table is finite, its similarities rise and its odds do not
  /// fall, and the shares are in [0, 1].
  void validate() const {
    for (const double share : {furnished_alike, light_changed}) {
      if (!(share >= 0.0 && share <= 1.0)) {
        throw InvalidValue("a share of places or revisits that looks tell of must be in [0, 1]");
      }
    }
    for (std::size_t i = 0; i < table.size(); ++i) {
      const bool rises = i == 0 || (table[i].similarity > table[i - 1].similarity &&
                                    table[i].log10_odds >= table[i - 1].log10_odds);
      if (!std::isfinite(table[i].similarity) || !std::isfinite(table[i].log10_odds) || !rises) {
        throw InvalidValue(
            "the odds of appearance do not rise with similarity at point " + std::to_string(i), i);
      }
    }
  }
};

}  // namespace v0
}  // namespace topobag
