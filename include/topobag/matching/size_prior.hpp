// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <map>

#include <topobag/matching/detail/few_keys.hpp>
#include <topobag/types/ids.hpp>

namespace topobag {
inline namespace v0 {

/// How the sizes of a class's objects differ: standard deviations of the logarithm of their width
/// and of their height, as seen.
struct SizeSpread {
  std::array<double, 2> within{0.14, 0.14};   ///< of one place: six equal chairs round a table
  std::array<double, 2> between{0.14, 0.14};  ///< of what the objects of a place have in common
};

/// What the sizes of matched objects say: of one object seen twice they are nearly equal, of two
/// objects of a class they are not. But things of a class that stand together were bought together,
/// so that of many equal sizes only the first is news.
///
/// The logarithms of the ratios of k pairs of a class are N(0, deviation²) each if they are the
/// same objects; between two places they share an offset, N(0, 2 between²), and each is
/// N(offset, 2 within² + deviation²). The second kind is worked out pair by pair, each given those
/// before it (a Kalman filter of the offset), so that the factors add up to the exact odds.
struct SizePrior {
  SizePrior() {}  // by default, g++ 12 warns that the map is not initialised where an option is

  double deviation = 0.15;  ///< of the logarithm of one object's width or height, seen twice
  double outliers = 0.10;   ///< share of the sides that tell nothing: cut or misread boxes
  SizeSpread spread;        ///< of classes of which nothing is known: most things that are made
  std::map<ClassId, SizeSpread> classes;  ///< of the others (`learn_sizes.hpp`)

  /// Of a class. O(log classes).
  const SizeSpread& of(ClassId label) const {
    const auto known = classes.find(label);
    return known == classes.end() ? spread : known->second;
  }
};

/// Adds up what the sizes of the matched pairs of a pose say.
class SizeEvidence {
 public:
  /// Of no pair yet. @param prior  referred to; it has to stay
  explicit SizeEvidence(const SizePrior& prior) : prior_(prior) {}

  /// log10 P(ratios of the two widths and heights | one object) / P(ratios | two objects of places
  /// that differ), given the pairs of the class so far. 0 where one is unknown (0). O(log classes).
  /// @param label   the map's
  /// @param size_a  width and height, m; an `Eigen` vector, as is `size_b`
  template <typename Size>
  double log10_factor(ClassId label, const Size& size_a, const Size& size_b) {
    double factor = 1.0;
    const SizeSpread& spread = prior_.of(label);
    const auto [offsets, is_new] = offsets_.insert(label);
    for (std::size_t side = 0; side < 2; ++side) {
      if (is_new) offsets[side].variance = 2.0 * squared(spread.between[side]);
      const auto i = static_cast<int>(side);
      const double a = static_cast<double>(size_a[i]), b = static_cast<double>(size_b[i]);
      if (!(a > 0.0 && b > 0.0)) continue;
      factor *= factor_of(offsets[side], spread.within[side], std::log(a / b));
    }
    return std::log10(factor);
  }

 private:
  /// What the objects of a class have in common in one place, less what they have in the other.
  struct Offset {
    double mean = 0.0;
    double variance = 0.0;
  };

  static double squared(double x) { return x * x; }

  double factor_of(Offset& offset, double within, double ratio) const {
    const double same = squared(prior_.deviation);
    const double apart = 2.0 * squared(within) + same;
    const double predicted = offset.variance + apart;
    const double factor =
        std::sqrt(predicted / same) *
        std::exp(0.5 * squared(ratio - offset.mean) / predicted - 0.5 * squared(ratio) / same);
    const double gain = offset.variance / predicted;
    offset.mean += gain * (ratio - offset.mean);
    offset.variance *= 1.0 - gain;
    return prior_.outliers + (1.0 - prior_.outliers) * factor;
  }

  const SizePrior& prior_;
  detail::FewKeys<ClassId, std::array<Offset, 2>> offsets_;  ///< of widths and heights
};

}  // namespace v0
}  // namespace topobag
