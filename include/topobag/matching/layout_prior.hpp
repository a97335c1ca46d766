// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include <topobag/error.hpp>
#include <topobag/sensing/sensor_profile.hpp>
#include <topobag/types/detail/one_alignment.hpp>
#include <topobag/types/ids.hpp>

namespace topobag {
inline namespace v0 {

/// Bins of distance, each as wide for its distance as the others.
struct DistanceBins {
  static constexpr std::size_t count = 14;      ///< of them
  static constexpr double least = 0.08;         ///< m; what is nearer falls into the first bin
  static constexpr double most = layout_range;  ///< m; objects further apart are not counted

  /// The lower border of a bin, m; of `count`, the last one's upper border.
  static double border(std::size_t bin) {
    return least * std::pow(most / least, static_cast<double>(bin) / count);
  }
  /// Of the ring in the plane whose radii are a bin's borders, m².
  static double area(std::size_t bin) {
    const double inner = bin == 0 ? 0.0 : border(bin), outer = border(bin + 1);
    return 3.141592653589793 * (outer * outer - inner * inner);
  }
  /// Of a distance, m.
  static std::size_t of(double distance) {
    const double bin = count * std::log(std::max(distance, least) / least) / std::log(most / least);
    return std::min(static_cast<std::size_t>(bin), count - 1);
  }
};

/// At which distances the objects of two classes stand: places, each shared among its pairs.
using DistanceCounts = std::array<double, DistanceBins::count>;

/// How objects are usually laid out: at which distances from each other those of two classes stand,
/// in places that are not the map's (`learn_layouts.hpp`).
///
/// A mouse lies beside its keyboard wherever there are two, so that finding them so in two places
/// proves little. Chance, which otherwise strews matched objects evenly over an area, then strews
/// them as other places do: the first one evenly, each other one at a usual distance from one of
/// those before it, or, with probability `even`, evenly as well. Which one depends on which is what
/// makes the layout least surprising: the spanning tree of the largest odds (Chow and Liu 1968,
/// with the odds of this very layout in place of their mean), so that each object counts once.
///
/// Distances are level ones where the vertical is known, those in space elsewhere.
class LayoutPrior {
 public:
  double even = 0.5;    ///< share of objects that stand anywhere
  double pooled = 3.0;  ///< places that what holds for all pairs of classes counts for

  /// Counts pairs of two classes. Throws InvalidValue for a count that is negative or not finite.
  /// O(log pairs).
  void add(ClassId a, ClassId b, const DistanceCounts& level, const DistanceCounts& spatial) {
    for (const DistanceCounts* counts : {&level, &spatial}) {
      for (const double count : *counts) {
        if (!(count >= 0.0 && std::isfinite(count))) {
          throw InvalidValue("a count of distances must be finite and not negative");
        }
      }
    }
    Layout& layout = layouts_[std::minmax(a, b)];
    for (std::size_t bin = 0; bin < DistanceBins::count; ++bin) {
      layout[0][bin] += level[bin];
      layout[1][bin] += spatial[bin];
      all_[0][bin] += level[bin];
      all_[1][bin] += spatial[bin];
    }
  }

  bool empty() const noexcept { return layouts_.empty(); }

  /// Calls `f(a, b, level, spatial)` for every pair of classes that was counted, a ≤ b, ascending.
  template <typename F>
  void for_each(F&& f) const {
    for (const auto& [classes, layout] : layouts_) {
      f(classes.first, classes.second, layout[0], layout[1]);
    }
  }

  /// 1/m² in the plane: how densely objects of one class stand around one of the other at this
  /// distance, when both lie within `extent` (m) of each other. O(bins + log pairs).
  double density(ClassId a, ClassId b, double distance, double extent, bool level) const {
    const std::size_t kind = level ? 0 : 1;
    const auto known = layouts_.find(std::minmax(a, b));
    const std::size_t here = DistanceBins::of(distance);
    const std::size_t last = std::max(here, DistanceBins::of(extent));
    const double all = std::accumulate(all_[kind].begin(), all_[kind].end(), 0.0);
    double within = 0.0, share = 0.0;
    for (std::size_t bin = 0; bin <= last; ++bin) {
      // Half of what is said of all pairs is that they stand anywhere.
      const double even_share = DistanceBins::area(bin) / even_area();
      double weight =
          pooled * (all > 0.0 ? 0.5 * (all_[kind][bin] / all + even_share) : even_share);
      if (known != layouts_.end()) weight += known->second[kind][bin];
      within += weight;
      if (bin == here) share = weight;
    }
    return share / within / DistanceBins::area(here);
  }

  /// log10 P(layout | other places) / P(layout | strewn evenly over `area`). O(n² bins).
  /// @param labels     of the objects
  /// @param positions  of these, m; in the plane where the vertical is known
  /// @param area       m², over which chance strews otherwise
  /// @param extent     m, of that area's diagonal
  double log10_odds(const std::vector<ClassId>& labels,
                    const std::vector<Eigen::Vector3d>& positions, double area, double extent,
                    bool level) const {
    if (labels.size() < 2) return 0.0;
    std::vector<double> best(labels.size(), 0.0);  // odds of the best link to the tree (Prim)
    std::vector<bool> in_tree(labels.size(), false);
    double log10_odds = 0.0;
    std::size_t newest = 0;
    for (std::size_t links = 1; links < labels.size(); ++links) {
      in_tree[newest] = true;
      std::size_t next = labels.size();
      for (std::size_t i = 0; i < labels.size(); ++i) {
        if (in_tree[i]) continue;
        const double distance = (positions[i] - positions[newest]).norm();
        const double usual = density(labels[i], labels[newest], distance, extent, level);
        best[i] = std::max(best[i], even + (1.0 - even) * usual * area);
        if (next == labels.size() || best[i] > best[next]) next = i;
      }
      log10_odds += std::log10(best[next]);
      newest = next;
    }
    return log10_odds;
  }

 private:
  using Layout = std::array<DistanceCounts, 2>;  // level, in space

  static double even_area() {
    const double radius = DistanceBins::most;
    return 3.141592653589793 * radius * radius;
  }

  std::map<std::pair<ClassId, ClassId>, Layout> layouts_;
  Layout all_{};
};

}  // namespace v0
}  // namespace topobag
