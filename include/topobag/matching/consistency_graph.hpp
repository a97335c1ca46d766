// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include <topobag/graph/topology_graph.hpp>
#include <topobag/matching/class_groups.hpp>
#include <topobag/matching/correspondence.hpp>
#include <topobag/matching/detail/bit_matrix.hpp>
#include <topobag/matching/point_pair.hpp>

namespace topobag {
inline namespace v0 {

/// When two nodes may be one object, and when two such pairs agree.
struct ConsistencyOptions {
  ClassGroups classes{};        ///< same class, and what the user adds
  double max_size_ratio = 3.0;  ///< between the diagonals of two objects; a cut box shrinks
  double deviations = 2.5;      ///< standard deviations that two distances may differ by
  double min_tolerance = 0.05;  ///< m, whatever the covariances say
  double max_tolerance = 0.40;  ///< m
  std::size_t max_pairs = 512;  ///< beyond it the classes with the most pairs are left out
};

/// The same-class node pairs of two graphs, and which of them agree: pairs (p, q), (p', q') of
/// different nodes whose distances d(p, p') and d(q, q') are equal within the nodes' noise.
class ConsistencyGraph {
 public:
  /// O(a²) for a same-class pairs.
  template <typename Scalar>
  ConsistencyGraph(const TopologyGraph<Scalar>& candidate, const TopologyGraph<Scalar>& query,
                   const ConsistencyOptions& options)
      : pairs_(offered_pairs(candidate, query, options, complete_)),
        agreement_(pairs_.size(), pairs_.size()) {
    points_.reserve(pairs_.size());
    for (const Correspondence& pair : pairs_) {
      points_.push_back(point_pair(candidate.node(pair.candidate), query.node(pair.query)));
      query_of_.push_back(value(pair.query));
    }
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
      for (std::size_t j = i + 1; j < pairs_.size(); ++j) {
        if (pairs_[i].query == pairs_[j].query || pairs_[i].candidate == pairs_[j].candidate)
          continue;
        if (!agree(points_[i], points_[j], options)) continue;
        agreement_.set(i, j);
        agreement_.set(j, i);
      }
    }
  }

  /// Sorted by query node, then candidate node.
  const std::vector<Correspondence>& pairs() const noexcept { return pairs_; }
  /// Their positions, in the order of `pairs`; the candidate is the target.
  const std::vector<PointPair>& points() const noexcept { return points_; }
  /// Which pairs agree: symmetric, false on the diagonal.
  const detail::BitMatrix& agreement() const noexcept { return agreement_; }

  /// Query node of each pair: two pairs of one query node never agree.
  const std::vector<std::size_t>& query_of() const noexcept { return query_of_; }

  /// False when `max_pairs` left pairs out.
  bool complete() const noexcept { return complete_; }

 private:
  template <typename Scalar>
  static std::vector<Correspondence> offered_pairs(const TopologyGraph<Scalar>& candidate,
                                                   const TopologyGraph<Scalar>& query,
                                                   const ConsistencyOptions& options,
                                                   bool& complete) {
    std::vector<Correspondence> pairs;
    std::map<ClassId, std::size_t> pairs_of_class;
    for (std::size_t q = 0; q < query.size(); ++q) {
      if (!query.nodes()[q].position) continue;
      for (std::size_t p = 0; p < candidate.size(); ++p) {
        if (!candidate.nodes()[p].position) continue;
        if (!options.classes.compatible(candidate.nodes()[p].label, query.nodes()[q].label))
          continue;
        if (!sizes_fit(candidate.nodes()[p], query.nodes()[q], options.max_size_ratio)) continue;
        pairs.push_back({node_index(p), node_index(q)});
        ++pairs_of_class[query.nodes()[q].label];
      }
    }
    complete = pairs.size() <= options.max_pairs;
    if (complete) return pairs;

    std::vector<std::pair<std::size_t, ClassId>> rarest;
    for (const auto& [label, count] : pairs_of_class) rarest.emplace_back(count, label);
    std::sort(rarest.begin(), rarest.end());
    std::size_t total = 0;
    for (const auto& [count, label] : rarest) {
      total += count;
      if (total > options.max_pairs) pairs_of_class[label] = 0;
    }
    pairs.erase(std::remove_if(pairs.begin(), pairs.end(),
                               [&](const Correspondence& pair) {
                                 return pairs_of_class[query.node(pair.query).label] == 0;
                               }),
                pairs.end());
    return pairs;
  }

  template <typename Node>
  static bool sizes_fit(const Node& a, const Node& b, double max_ratio) {
    const double size_a = static_cast<double>(a.size.norm());
    const double size_b = static_cast<double>(b.size.norm());
    if (size_a <= 0.0 || size_b <= 0.0) return true;
    return std::max(size_a, size_b) <= max_ratio * std::min(size_a, size_b);
  }

  template <typename Pair>
  static bool agree(const Pair& i, const Pair& j, const ConsistencyOptions& options) {
    const Eigen::Vector3d p = i.target - j.target;
    const Eigen::Vector3d q = i.source - j.source;
    const double length_p = p.norm();
    const double length_q = q.norm();
    const double difference = std::abs(length_p - length_q);
    if (difference <= options.min_tolerance) return true;
    if (difference > options.max_tolerance) return false;
    const double variance = variance_along(p, length_p, i.target_covariance + j.target_covariance) +
                            variance_along(q, length_q, i.source_covariance + j.source_covariance);
    return difference * difference <= options.deviations * options.deviations * variance;
  }

  template <typename Line>
  static double variance_along(const Eigen::MatrixBase<Line>& line, double length,
                               const Eigen::Matrix3d& covariance) {
    return length > 0.0 ? line.dot(covariance * line) / (length * length)
                        : covariance.trace() / 3.0;
  }

  bool complete_ = true;
  std::vector<Correspondence> pairs_;
  std::vector<PointPair> points_;
  std::vector<std::size_t> query_of_;
  detail::BitMatrix agreement_;
};

}  // namespace v0
}  // namespace topobag
