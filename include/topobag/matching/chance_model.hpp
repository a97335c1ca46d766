// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <vector>

#include <Eigen/Core>

#include <topobag/graph/topology_graph.hpp>
#include <topobag/matching/class_groups.hpp>
#include <topobag/matching/correspondence.hpp>

namespace topobag {
inline namespace v0 {

/// How probable a match is when the two places have nothing to do with each other.
///
/// A-contrario (Desolneux, Moisan, Morel 2000; for rigid point matches Moisan and Stival 2004): the
/// expected number of false matches is the number of ways to choose the pairs times the probability
/// that one such choice fits a rigid motion this well.
struct ChanceModel {
  double min_residual = 0.04;  ///< m; a better fit than this is luck
  double xl = 0.3;
  double lw = 0, ls = 1;
  double fill = 0.35;  ///< share of the cube of the graph's extent in which objects lie

  /// −log10 of the expected number of false matches with as many pairs and as small an `rms`
  /// residual.
  /// @param pairs  one-to-one, k >= 3, else the significance is 0
  /// @param rms    residual of the rigid fit, m
  /// O(n + k).
  template <typename Scalar>
  double significance(const TopologyGraph<Scalar>& candidate, const TopologyGraph<Scalar>& query,
                      const std::vector<Correspondence>& pairs, double rms,
                      const ClassGroups& classes = {}) const {
    const std::size_t k = pairs.size();
    if (k < 3) return 0.0;
    struct Counts {
      std::size_t candidate = 0, query = 0, matched = 0;
    };
    std::map<ClassId, Counts> counts;
    for (const auto& node : candidate.nodes()) {
      if (node.position) ++counts[classes.group(node.label)].candidate;
    }
    for (const auto& node : query.nodes()) {
      if (node.position) ++counts[classes.group(node.label)].query;
    }
    for (const Correspondence& pair : pairs)
      ++counts[classes.group(query.node(pair.query).label)].matched;

    double log_ways = 0.0;
    std::size_t most = 0;
    for (const auto& [label, c] : counts) {
      most += std::min(c.candidate, c.query);
      // Compatible classes may pair more nodes of a class than one graph has of it.
      const std::size_t n1 = std::max(c.candidate, c.matched);
      const std::size_t n2 = std::max(c.query, c.matched);
      log_ways += log_choose(n1, c.matched) + log_choose(n2, c.matched) +
                  std::lgamma(static_cast<double>(c.matched) + 1.0);
    }
    log_ways += log_choose(std::max(most, k), k);

    std::vector<SemanticNode<Scalar>> mm;
    for (auto& pr : pairs) mm.push_back(candidate.node(pr.candidate));
    const double e1 = rms_extent(candidate.nodes()), e2 = rms_extent(mm);
    const double extent =
        std::max(2.0 * std::pow(e1, 1 - lw) * std::pow(ls * e2, lw), 4.0 * min_residual);
    const double residual = std::max(rms, min_residual);
    const double p_distance = std::min(1.0, 4.0 * residual / extent);
    const double ball = 4.0 / 3.0 * 3.14159265358979 * std::pow(2.0 * residual, 3);
    const double p_place = std::min(1.0, ball / (fill * std::pow(extent, 3)));
    const double log_fit =
        3.0 * std::log(p_distance) + static_cast<double>(k - 3) * std::log(p_place);
    double cross = 0;
    for (const Correspondence& pair : pairs)
      if (query.node(pair.query).label != candidate.node(pair.candidate).label) cross += xl;
    return -(log_ways + log_fit) / std::log(10.0) - cross;
  }

 private:
  static double log_choose(std::size_t n, std::size_t k) {
    const auto f = [](std::size_t x) { return std::lgamma(static_cast<double>(x) + 1.0); };
    return f(n) - f(k) - f(n - k);
  }

  /// Root mean square distance of the placed nodes from their centroid, m.
  template <typename Scalar>
  static double rms_extent(const std::vector<SemanticNode<Scalar>>& nodes) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    double squares = 0.0, n = 0.0;
    for (const auto& node : nodes) {
      if (!node.position) continue;
      const Eigen::Vector3d position = node.position->template cast<double>();
      sum += position;
      squares += position.squaredNorm();
      n += 1.0;
    }
    if (n == 0.0) return 0.0;
    return std::sqrt(std::max(0.0, squares / n - (sum / n).squaredNorm()));
  }
};

}  // namespace v0
}  // namespace topobag
