// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include <Eigen/Core>
#include <Eigen/LU>

#include <topobag/error.hpp>
#include <topobag/graph/topology_graph.hpp>
#include <topobag/matching/appearance_model.hpp>
#include <topobag/matching/class_affinity.hpp>
#include <topobag/matching/class_confusion.hpp>
#include <topobag/matching/class_groups.hpp>
#include <topobag/matching/correspondence.hpp>
#include <topobag/matching/detail/few_keys.hpp>
#include <topobag/matching/detail/slab.hpp>
#include <topobag/matching/layout_prior.hpp>
#include <topobag/matching/refine_pose.hpp>
#include <topobag/matching/scale_range.hpp>
#include <topobag/matching/shared_vertical.hpp>
#include <topobag/matching/size_prior.hpp>
#include <topobag/types/detail/cholesky.hpp>

namespace topobag {
inline namespace v0 {

/// How many matches as good as this one chance would give between places that have nothing in
/// common.
///
/// A-contrario (Desolneux, Moisan, Morel 2000): the number of false matches to expect is the number
/// of ways to choose the pairs times the probability that one choice fits so well. That probability
/// is at most the inverse Bayes factor (Markov's inequality: under chance its mean is 1) of two
/// models: each query object lies where the pose puts it, within the pair's covariance; or chance
/// put it there. The pose is integrated out (Laplace), so a compact cluster, whose pose is loose
/// and whose places are hardly a surprise, counts little.
///
/// Chance strews objects over a slab, not through space: in every room things stand on floors and
/// tables, and those of a class at about the same height. So the places along the slab are
/// surprising, over a rectangle of the matched objects' extent, but heights above it only by what
/// they differ within a class. Where no gravity is known the slab is the thinnest direction of the
/// matched objects, and chance, too, may tilt it as it likes: three objects then earn nothing by
/// their heights. (Strewn through space, rooms with nothing in common reached odds of 10⁶ to one.)
///
/// The widths and the heights of the paired objects speak as well (`SizePrior`); on real detections
/// the two sides err apart (their errors correlate by 0.1 to 0.2). So do their looks, where both
/// are known (`AppearanceModel`). Where things stand alike because they always do, a `LayoutPrior`
/// says so.
struct ChanceModel {
  double fill = 1.5;  ///< area that chance fills, in rectangles of the matched objects' scatter
  double min_extent = 0.10;     ///< m, of each of its sides
  double height_spread = 0.15;  ///< m; σ of the heights at which objects of one class stand
  SizePrior sizes;              ///< how sizes of one class differ
  double relabeling = 0.45;     ///< −log10 P of the label of a pair of two classes of one group
  /// With it, P of such a pair is that of the query's label given the candidate's.
  std::optional<ClassConfusion> confusion{};
  /// With it, P of such a pair is the affinity, whatever groups and confusion say.
  ClassAffinity affinity{};
  AppearanceModel appearance{};          ///< what the looks of a pair say
  std::optional<LayoutPrior> layouts{};  ///< with it, chance strews the matched objects as they
                                         ///< usually stand

  /// −log10 of the expected number of false matches. 0 for fewer than three pairs, or two where the
  /// vertical is known. O(n + k).
  /// @param pairs   of nodes with positions, one-to-one, each within a group or of a common label.
  ///                Throws InvalidValue for others: there is no way to choose them
  /// @param points  their positions and covariances, parallel to `pairs`: a range of `PointPair`
  /// @param pose    fitted to `points`, with its covariance
  /// @param vertical  where both frames know it
  template <typename Scalar, typename Points = std::vector<PointPair>>
  double significance(const TopologyGraph<Scalar>& candidate, const TopologyGraph<Scalar>& query,
                      const std::vector<Correspondence>& pairs, const Points& points,
                      const RefinedPose& pose, const ClassGroups& groups = {},
                      const std::optional<SharedVertical>& vertical = std::nullopt) const {
    if (pairs.size() < (vertical ? 2U : 3U)) return 0.0;
    const auto joined = joined_by(pairs, candidate, query, groups, affinity);
    double significance = log10_bayes_factor(points, pose, vertical) -
                          log10_ways(candidate, query, pairs, joined ? *joined : groups);
    SizeEvidence sizes_so_far(sizes);
    double looks = 0.0;  // log10 odds of the pairs, added up
    for (const Correspondence& pair : pairs) {
      const auto& p = candidate.node(pair.candidate);
      const auto& q = query.node(pair.query);
      if (p.label != q.label || detail::has_weights(p, q)) {
        const double in_group = confusion ? confusion->cost(p.label, q.label) : relabeling;
        significance -= label_cost(p, q, groups, affinity, in_group);
      }
      significance += sizes_so_far.log10_factor(p.label, p.size, q.size);
      looks += appearance.log10_odds(p.appearance, q.appearance);
    }
    if (looks != 0.0) significance += appearance.log10_odds_together(looks);
    if (layouts) significance -= log10_layout_odds(query, pairs, points, vertical);
    // Not so where rounding leaves the covariance of a pose, or of a pair, without a root.
    return std::isfinite(significance) ? significance : std::numeric_limits<double>::lowest();
  }

  /// log10 P(places of the query objects | pose unknown, same place) / P(places | chance).
  /// @param points    a range of `PointPair`
  /// @param vertical  where both frames know it
  template <typename Points = std::vector<PointPair>>
  double log10_bayes_factor(const Points& points, const RefinedPose& pose,
                            const std::optional<SharedVertical>& vertical = std::nullopt) const {
    const double log_two_pi = 1.8378770664093453;
    const auto n = static_cast<double>(points.size());
    const detail::Slab slab(points, vertical ? &*vertical : nullptr);
    const double log_area = std::log(area(slab));
    double log_factor = 0.0;
    double height_variance = 0.0;  // under chance, the mean
    for (const auto& pair : points) {
      const Eigen::Vector3d residual = pair.residual(pose.T_target_source);
      const Eigen::Matrix3d covariance = pair.covariance(pose.T_target_source);
      const double deviation2 = residual.dot(covariance.inverse() * residual);
      const double height = slab.normal.dot(residual);
      const double variance =
          slab.normal.dot(covariance * slab.normal) + height_spread * height_spread;
      // Normal densities: of three dimensions where the pose puts it, of the height by chance.
      log_factor += log_area + 0.5 * (height * height / variance - deviation2) - log_two_pi +
                    0.5 * std::log(variance / covariance.determinant());
      height_variance += variance / n;
    }
    // The pose's prior: anywhere on the area, turned any way about the normal. How high it is, and
    // how tilted where nothing tells, chance is as free to choose.
    double log_prior = -log_area - log_two_pi;
    log_factor -= 0.5 * (log_two_pi + std::log(height_variance / n));
    if (vertical) {
      const Eigen::Vector3d tilt = vertical->tilt(pose.T_target_source.linear());
      log_prior -=
          log_two_pi + std::log(vertical->variance) + 0.5 * tilt.squaredNorm() / vertical->variance;
    } else {
      const double least = 1e-3;  // m²; of objects in a row, which leave the pose open anyway
      log_factor -= log_two_pi + std::log(height_variance / n) -
                    std::log(std::max(least, slab.tilt_information));
    }
    const double log_posterior_volume =
        3.0 * log_two_pi + detail::log_root_determinant(pose.covariance);
    return (log_factor + log_prior + log_posterior_volume) / std::log(10.0);
  }

  /// What a match loses by a scale that was chosen to fit, log10 of how many scales the range holds
  /// that can be told apart: the Bayes factor is a mean over all of them, of which the pairs fill
  /// √(2π) deviations (Laplace, as of the pose: the seven unknowns' covariance has the determinant
  /// of the pose's, at the best scale, times this variance). 1.6 for 3 % in a range of 16.
  /// @param deviation  of the scale's logarithm, with the pose unknown
  static double log10_scale_cost(const ScaleRange& range, double deviation) {
    const double root_two_pi = 2.5066282746310002;
    return std::max(0.0, std::log10(range.log_width() / (root_two_pi * deviation)));
  }

  /// log10 of the number of ways to choose which same-group nodes pair up: per group with q of n
  /// and m nodes, C(n, q) · C(m, q) · q! choices, and min(n, m) + 1 values that q may take. Throws
  /// InvalidValue for pairs that cannot be chosen so.
  template <typename Scalar>
  static double log10_ways(const TopologyGraph<Scalar>& candidate,
                           const TopologyGraph<Scalar>& query,
                           const std::vector<Correspondence>& pairs, const ClassGroups& groups) {
    struct Counts {
      std::size_t candidate = 0, query = 0, matched = 0;
    };
    detail::FewKeys<ClassId, Counts> counts;
    for (const auto& node : candidate.nodes()) {
      if (node.position) ++counts[groups.group(node.label)].candidate;
    }
    for (const auto& node : query.nodes()) {
      if (node.position) ++counts[groups.group(node.label)].query;
    }
    for (const Correspondence& pair : pairs) {
      ++counts[groups.group(query.node(pair.query).label)].matched;
    }
    double log_ways = 0.0;
    for (const auto& [group, c] : counts) {
      const std::size_t most = std::min(c.candidate, c.query);
      if (c.matched > most) {
        throw InvalidValue(
            "the pairs cannot be chosen: they have to be one-to-one, of nodes with positions and "
            "of one class or one group of classes");
      }
      log_ways += log_choose(c.candidate, c.matched) + log_choose(c.query, c.matched) +
                  log_factorial(c.matched) + log_choose(most + 1, most);  // most + 1 values
    }
    return log_ways / std::log(10.0);
  }

 private:
  /// m², over which chance strews the matched objects.
  double area(const detail::Slab& slab) const {
    return fill * std::max(min_extent, slab.length) * std::max(min_extent, slab.width);
  }

  /// How much more likely other places lay the query's matched objects out so than chance does that
  /// strews them evenly.
  template <typename Scalar, typename Points>
  double log10_layout_odds(const TopologyGraph<Scalar>& query,
                           const std::vector<Correspondence>& pairs, const Points& points,
                           const std::optional<SharedVertical>& vertical) const {
    const detail::Slab slab(points, vertical ? &*vertical : nullptr);
    std::vector<ClassId> labels;
    std::vector<Eigen::Vector3d> positions;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      labels.push_back(query.node(pairs[i].query).label);
      positions.push_back(points[i].source);
      if (!vertical) continue;
      const Eigen::Vector3d& down = vertical->source_down;
      positions.back() -= down * down.dot(points[i].source);
    }
    const double extent =
        std::hypot(std::max(min_extent, slab.length), std::max(min_extent, slab.width));
    return layouts->log10_odds(labels, positions, area(slab), extent, vertical.has_value());
  }

  static double log_factorial(std::size_t n) {
    static const std::array<double, 64> known = [] {
      std::array<double, 64> logs{};
      for (std::size_t i = 1; i < logs.size(); ++i) {
        logs[i] = logs[i - 1] + std::log(static_cast<double>(i));
      }
      return logs;
    }();
    return n < known.size() ? known[n] : std::lgamma(static_cast<double>(n) + 1.0);
  }
  static double log_choose(std::size_t n, std::size_t k) {
    return log_factorial(n) - log_factorial(k) - log_factorial(n - k);
  }
};

}  // namespace v0
}  // namespace topobag
