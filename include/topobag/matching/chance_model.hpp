// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <optional>
#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/LU>

#include <topobag/graph/topology_graph.hpp>
#include <topobag/matching/class_confusion.hpp>
#include <topobag/matching/class_groups.hpp>
#include <topobag/matching/correspondence.hpp>
#include <topobag/matching/refine_pose.hpp>

namespace topobag {
inline namespace v0 {

/// How many matches as good as this one chance would give between places that have nothing in
/// common.
///
/// A-contrario (Desolneux, Moisan, Morel 2000): the number of false matches to expect is the number
/// of ways to choose the pairs times the probability that one choice fits so well. That probability
/// is at most the inverse Bayes factor (Markov's inequality: under chance its mean is 1) of two
/// models: each query object lies where the pose puts it, within the pair's covariance; or anywhere
/// in the volume that the matched objects span. The pose is integrated out (Laplace), so a compact
/// cluster, whose pose is loose and whose places are hardly a surprise, counts little. The widths
/// and the heights of the paired objects speak in the same way: of one object seen twice they are
/// nearly equal, of two objects of a class they are not; on real detections the two sides err apart
/// (their errors correlate by 0.1 to 0.2).
struct ChanceModel {
  double fill = 1.5;  ///< share of the cube of the matched objects' extent that is the volume
  double min_extent = 0.10;      ///< m
  double size_deviation = 0.15;  ///< of the logarithm of one object's width or height, seen twice
  double size_spread = 0.45;     ///< of the same between two objects of one class
  double size_outliers = 0.10;   ///< share of the sides that tell nothing: cut or misread boxes
  double relabeling = 0.45;      ///< −log10 P of the label of a pair of two classes of one group
  std::optional<ClassConfusion> confusion{};  ///< with it, that is P of the query's label given the
                                              ///< candidate's

  /// −log10 of the expected number of false matches. 0 for fewer than three pairs. O(n + k).
  /// @param pairs   of nodes with positions, one-to-one
  /// @param points  their positions and covariances, parallel to `pairs`
  /// @param pose    fitted to `points`, with its covariance
  template <typename Scalar>
  double significance(const TopologyGraph<Scalar>& candidate, const TopologyGraph<Scalar>& query,
                      const std::vector<Correspondence>& pairs,
                      const std::vector<PointPair>& points, const RefinedPose& pose,
                      const ClassGroups& groups = {}) const {
    if (pairs.size() < 3) return 0.0;
    double significance =
        log10_bayes_factor(points, pose) - log10_ways(candidate, query, pairs, groups);
    for (const Correspondence& pair : pairs) {
      const auto& p = candidate.node(pair.candidate);
      const auto& q = query.node(pair.query);
      if (p.label != q.label) {
        significance -= confusion ? confusion->cost(p.label, q.label) : relabeling;
      }
      for (Eigen::Index side = 0; side < 2; ++side) {
        significance +=
            log10_size_factor(static_cast<double>(p.size(side)), static_cast<double>(q.size(side)));
      }
    }
    // Not so where rounding leaves the covariance of a pose, or of a pair, without a root.
    return std::isfinite(significance) ? significance : std::numeric_limits<double>::lowest();
  }

  /// log10 P(ratio of two widths, or heights | one object) / P(ratio | two objects of a class).
  /// 0 where one is unknown (0).
  double log10_size_factor(double size_a, double size_b) const {
    if (!(size_a > 0.0 && size_b > 0.0)) return 0.0;
    const double ratio = std::log(size_a / size_b);
    const double precision_gain =
        1.0 / (size_deviation * size_deviation) - 1.0 / (size_spread * size_spread);
    const double factor =
        size_spread / size_deviation * std::exp(-0.5 * ratio * ratio * precision_gain);
    return std::log10(size_outliers + (1.0 - size_outliers) * factor);
  }

  /// log10 P(places of the query objects | pose unknown, same place) / P(places | chance).
  /// @param points  a range of `PointPair`
  template <typename Points = std::vector<PointPair>>
  double log10_bayes_factor(const Points& points, const RefinedPose& pose) const {
    const double log_two_pi = 1.8378770664093453;
    const double log_volume = std::log(fill) + 3.0 * std::log(std::max(min_extent, extent(points)));
    double log_factor = 0.0;
    for (const auto& pair : points) {
      const Eigen::Matrix3d covariance = pair.covariance(pose.T_target_source);
      const double deviation2 = pair.squared_deviation(pose.T_target_source);
      log_factor +=
          log_volume - 0.5 * (deviation2 + 3.0 * log_two_pi + std::log(covariance.determinant()));
    }
    // The prior of the pose: anywhere in the volume, turned any way (8π²).
    const double log_prior = -log_volume - std::log(78.95683520871486);
    const Eigen::LLT<Eigen::Matrix<double, 6, 6>> root(pose.covariance);
    const double log_posterior_volume =
        3.0 * log_two_pi + root.matrixLLT().diagonal().array().log().sum();
    return (log_factor + log_prior + log_posterior_volume) / std::log(10.0);
  }

  /// log10 of the number of ways to choose which same-group nodes pair up: per group with q of n
  /// and m nodes, C(n, q) · C(m, q) · q! choices, and min(n, m) + 1 values that q may take.
  template <typename Scalar>
  static double log10_ways(const TopologyGraph<Scalar>& candidate,
                           const TopologyGraph<Scalar>& query,
                           const std::vector<Correspondence>& pairs, const ClassGroups& groups) {
    struct Counts {
      std::size_t candidate = 0, query = 0, matched = 0;
    };
    std::map<ClassId, Counts> counts;
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
      log_ways += log_choose(c.candidate, c.matched) + log_choose(c.query, c.matched) +
                  log_factorial(c.matched) +
                  std::log(1.0 + static_cast<double>(std::min(c.candidate, c.query)));
    }
    return log_ways / std::log(10.0);
  }

 private:
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

  /// Twice the root mean square distance of the targets from their centroid, m.
  template <typename Points>
  static double extent(const Points& points) {
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (const auto& pair : points) mean += pair.target;
    mean /= static_cast<double>(points.size());
    double squares = 0.0;
    for (const auto& pair : points) squares += (pair.target - mean).squaredNorm();
    return 2.0 * std::sqrt(squares / static_cast<double>(points.size()));
  }
};

}  // namespace v0
}  // namespace topobag
