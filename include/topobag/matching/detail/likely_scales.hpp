// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include <topobag/graph/topology_graph.hpp>
#include <topobag/matching/class_affinity.hpp>
#include <topobag/matching/class_groups.hpp>
#include <topobag/matching/consistency_graph.hpp>
#include <topobag/matching/correspondence.hpp>
#include <topobag/matching/detail/distance_table.hpp>
#include <topobag/matching/detail/offered_pairs.hpp>
#include <topobag/matching/scale_range.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// Votes for the logarithm of a scale, each spread as a triangle over what it may mean.
class ScaleVotes {
 public:
  explicit ScaleVotes(const ScaleRange& range)
      : low_(std::log(range.least)),
        bins_(static_cast<std::size_t>(std::ceil(range.log_width() / bin_width)) + 1),
        curvature_(bins_ + 2 * margin, 0.0) {}

  /// O(1): a triangle's second difference is three numbers.
  /// @param log_scale  within the range
  void add(double log_scale, double deviation, double weight) {
    const auto center =
        margin + static_cast<std::size_t>(std::lround((log_scale - low_) / bin_width));
    const auto half = static_cast<std::size_t>(std::clamp(std::round(2.0 * deviation / bin_width),
                                                          2.0, static_cast<double>(margin) - 1.0));
    const double slope = weight / static_cast<double>(half * half);  // of area `weight`
    curvature_[center - half] += slope;
    curvature_[center] -= 2.0 * slope;
    if (center + half < curvature_.size()) curvature_[center + half] += slope;
  }

  /// The scales with most votes about them, best first. O(bins · log).
  std::vector<double> modes(std::size_t count) const {
    std::vector<double> density(curvature_.size());
    double slope = 0.0, height = 0.0;
    for (std::size_t i = 0; i < density.size(); ++i) {
      density[i] = height;
      slope += curvature_[i];
      height += slope;
    }
    const auto votes = [&](std::size_t bin) { return density[margin + bin]; };
    std::vector<std::pair<double, std::size_t>> peaks;
    for (std::size_t bin = 0; bin < bins_; ++bin) {
      const bool up = bin == 0 || votes(bin) > votes(bin - 1);
      const bool down = bin + 1 == bins_ || votes(bin) >= votes(bin + 1);
      if (votes(bin) > least_votes && up && down) peaks.emplace_back(-votes(bin), bin);
    }
    std::sort(peaks.begin(), peaks.end());
    std::vector<double> scales;
    std::vector<std::size_t> taken;
    for (const auto& [negative, bin] : peaks) {
      if (scales.size() == count) break;
      const std::size_t at = bin;
      const bool near = std::any_of(taken.begin(), taken.end(), [at](std::size_t other) {
        return std::max(at, other) - std::min(at, other) < apart;
      });
      if (near) continue;
      taken.push_back(bin);
      scales.push_back(std::exp(low_ + bin_width * static_cast<double>(bin)));
    }
    return scales;
  }

 private:
  static constexpr double bin_width = 0.02;
  static constexpr std::size_t margin = 48;  // bins on either side of the range
  static constexpr std::size_t apart = 3;    // bins, at least, between two modes
  static constexpr double least_votes = 1e-9;

  double low_;
  std::size_t bins_;
  std::vector<double> curvature_;
};

/// Which pairs of nodes may be one object in graphs of different units.
struct PairsOfAnySize {
  const ClassGroups& classes;
  const ClassAffinity& affinity;
  double min_affinity;
  double max_size_ratio = std::numeric_limits<double>::infinity();
};

/// The scales at which most pairs of objects may be the same ones, best first: each two pairs of
/// nodes vote for the ratio of their distances, as sharply as noise lets them, and the more the
/// better the objects' sizes go with it. O(pairs²).
template <typename Scalar>
std::vector<double> likely_scales(const TopologyGraph<Scalar>& candidate,
                                  const KnownDistances<Scalar>& query,
                                  const ConsistencyOptions& options, const ScaleRange& range) {
  const double size_deviation = 0.3;  // of the logarithm of one object's size, seen twice
  const double other_reasons = 0.1;   // a cut or misread box says nothing
  const double least_deviation = 0.02, greatest_deviation = 0.4;
  const PairsOfAnySize any{options.classes, options.affinity, options.min_affinity};
  auto pairs = offered_pairs(candidate, query.graph(), any);
  if (pairs.size() > options.max_pairs) {
    keep_telling(pairs, candidate, query.graph(), options.max_pairs);
  }
  std::vector<double> size_ratios;  // logarithms; NaN where not known
  for (const Correspondence& pair : pairs) {
    const auto there = static_cast<double>(candidate.node(pair.candidate).size.norm());
    const auto here = static_cast<double>(query.graph().node(pair.query).size.norm());
    size_ratios.push_back(there > 0.0 && here > 0.0 ? std::log(there / here)
                                                    : std::numeric_limits<double>::quiet_NaN());
  }
  const auto go_with = [&](double log_ratio, double log_scale) {
    if (std::isnan(log_ratio)) return 1.0;
    const double off = (log_ratio - log_scale) / size_deviation;
    return other_reasons + (1.0 - other_reasons) * std::exp(-0.5 * off * off);
  };
  const auto there = KnownDistances<Scalar>(candidate, options.noise).table(false);
  const auto here = query.table(false);
  ScaleVotes votes(range);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const Distance* p = there->row(value(pairs[i].candidate));
    const Distance* q = here->row(value(pairs[i].query));
    for (std::size_t j = i + 1; j < pairs.size(); ++j) {
      if (pairs[i].query == pairs[j].query || pairs[i].candidate == pairs[j].candidate) continue;
      const Distance& d_p = p[value(pairs[j].candidate)];
      const Distance& d_q = q[value(pairs[j].query)];
      if (!(d_p.length > 0.0 && d_q.length > 0.0)) continue;
      const double scale = d_p.length / d_q.length;
      if (!range.contains(scale)) continue;
      const double deviation = std::sqrt(d_p.variance / (d_p.length * d_p.length) +
                                         d_q.variance / (d_q.length * d_q.length));
      if (!(deviation <= greatest_deviation)) continue;
      const double log_scale = std::log(scale);
      votes.add(log_scale, std::max(least_deviation, deviation),
                go_with(size_ratios[i], log_scale) * go_with(size_ratios[j], log_scale));
    }
  }
  return votes.modes(range.max_tried);
}

}  // namespace detail
}  // namespace v0
}  // namespace topobag
