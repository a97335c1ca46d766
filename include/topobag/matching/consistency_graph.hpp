// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

#include <topobag/graph/topology_graph.hpp>
#include <topobag/matching/class_groups.hpp>
#include <topobag/matching/correspondence.hpp>
#include <topobag/matching/detail/bit_matrix.hpp>
#include <topobag/matching/detail/distance_table.hpp>
#include <topobag/matching/point_pair.hpp>
#include <topobag/types/ids.hpp>

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
  /// O(a² + n² + k²) for a same-class pairs of n and k nodes.
  template <typename Scalar>
  ConsistencyGraph(const TopologyGraph<Scalar>& candidate, const TopologyGraph<Scalar>& query,
                   const ConsistencyOptions& options)
      : pairs_(offered_pairs(candidate, query, options, complete_)),
        agreement_(pairs_.size(), pairs_.size()),
        candidate_distances_(candidate),
        query_distances_(query) {
    points_.reserve(pairs_.size());
    query_of_.reserve(pairs_.size());
    for (const Correspondence& pair : pairs_) {
      points_.push_back(point_pair(candidate.node(pair.candidate), query.node(pair.query)));
      query_of_.push_back(value(pair.query));
    }
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
      const detail::Distance* p = candidate_distances_.row(value(pairs_[i].candidate));
      const detail::Distance* q = query_distances_.row(value(pairs_[i].query));
      for (std::size_t j = i + 1; j < pairs_.size(); ++j) {
        if (pairs_[i].query == pairs_[j].query || pairs_[i].candidate == pairs_[j].candidate)
          continue;
        if (!agree(p[value(pairs_[j].candidate)], q[value(pairs_[j].query)], options)) continue;
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

  /// d(p, p') − d(q, q') of the pairs `i` and `j`, m.
  double difference(std::size_t i, std::size_t j) const noexcept {
    const auto length = [](const detail::DistanceTable& table, NodeIndex a, NodeIndex b) {
      return table.row(value(a))[value(b)].length;
    };
    return length(candidate_distances_, pairs_[i].candidate, pairs_[j].candidate) -
           length(query_distances_, pairs_[i].query, pairs_[j].query);
  }

  /// False when `max_pairs` left pairs out.
  bool complete() const noexcept { return complete_; }

 private:
  template <typename Scalar>
  static std::vector<Correspondence> offered_pairs(const TopologyGraph<Scalar>& candidate,
                                                   const TopologyGraph<Scalar>& query,
                                                   const ConsistencyOptions& options,
                                                   bool& complete) {
    std::vector<Correspondence> pairs;
    pairs.reserve(candidate.size() + query.size());
    std::vector<ClassId> candidate_groups;
    candidate_groups.reserve(candidate.size());
    for (const auto& node : candidate.nodes()) {
      candidate_groups.push_back(options.classes.group(node.label));
    }
    for (std::size_t q = 0; q < query.size(); ++q) {
      if (!query.nodes()[q].position) continue;
      const ClassId group = options.classes.group(query.nodes()[q].label);
      for (std::size_t p = 0; p < candidate.size(); ++p) {
        if (!candidate.nodes()[p].position) continue;
        if (candidate_groups[p] != group) continue;
        if (!sizes_fit(candidate.nodes()[p], query.nodes()[q], options.max_size_ratio)) continue;
        pairs.push_back({node_index(p), node_index(q)});
      }
    }
    complete = pairs.size() <= options.max_pairs;
    if (!complete) leave_common_classes_out(pairs, query, options.max_pairs);
    return pairs;
  }

  template <typename Scalar>
  static void leave_common_classes_out(std::vector<Correspondence>& pairs,
                                       const TopologyGraph<Scalar>& query, std::size_t max_pairs) {
    std::map<ClassId, std::size_t> pairs_of_class;
    for (const Correspondence& pair : pairs) ++pairs_of_class[query.node(pair.query).label];
    std::vector<std::pair<std::size_t, ClassId>> rarest;
    for (const auto& [label, count] : pairs_of_class) rarest.emplace_back(count, label);
    std::sort(rarest.begin(), rarest.end());
    std::size_t total = 0;
    for (const auto& [count, label] : rarest) {
      total += count;
      if (total > max_pairs) pairs_of_class[label] = 0;
    }
    pairs.erase(std::remove_if(pairs.begin(), pairs.end(),
                               [&](const Correspondence& pair) {
                                 return pairs_of_class[query.node(pair.query).label] == 0;
                               }),
                pairs.end());
  }

  template <typename Node>
  static bool sizes_fit(const Node& a, const Node& b, double max_ratio) {
    const double size_a = static_cast<double>(a.size.norm());
    const double size_b = static_cast<double>(b.size.norm());
    if (size_a <= 0.0 || size_b <= 0.0) return true;
    return std::max(size_a, size_b) <= max_ratio * std::min(size_a, size_b);
  }

  static bool agree(const detail::Distance& p, const detail::Distance& q,
                    const ConsistencyOptions& options) {
    const double difference = std::abs(p.length - q.length);
    if (difference <= options.min_tolerance) return true;
    if (difference > options.max_tolerance) return false;
    return difference * difference <=
           options.deviations * options.deviations * (p.variance + q.variance);
  }

  bool complete_ = true;
  std::vector<Correspondence> pairs_;
  std::vector<PointPair> points_;
  std::vector<std::size_t> query_of_;
  detail::BitMatrix agreement_;
  detail::DistanceTable candidate_distances_;
  detail::DistanceTable query_distances_;
};

}  // namespace v0
}  // namespace topobag
