// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include <topobag/graph/topology_graph.hpp>
#include <topobag/matching/class_affinity.hpp>
#include <topobag/matching/class_groups.hpp>
#include <topobag/matching/correspondence.hpp>
#include <topobag/matching/detail/bit_matrix.hpp>
#include <topobag/matching/detail/distance_table.hpp>
#include <topobag/matching/detail/offered_pairs.hpp>
#include <topobag/matching/point_pair.hpp>
#include <topobag/matching/shared_vertical.hpp>
#include <topobag/sensing/sensor_profile.hpp>
#include <topobag/types/ids.hpp>

namespace topobag {
inline namespace v0 {

/// When two nodes may be one object, and when two such pairs agree.
struct ConsistencyOptions {
  ClassGroups classes{};        ///< same class, and what the user adds
  ClassAffinity affinity{};     ///< when set, decides instead (see `may_be_one`)
  double min_affinity = 0.05;   ///< of two nodes' labels that may be one object's
  double max_size_ratio = 3.0;  ///< between the diagonals of two objects; a cut box shrinks
  double deviations = 2.5;      ///< standard deviations that two distances may differ by
  double min_tolerance = default_sensor.least_tolerance;  ///< m, whatever the covariances say
  double max_tolerance = default_sensor.gate;             ///< m
  NodeNoise noise = default_sensor.noise;  ///< of a node without a covariance, here and in the fit
  std::size_t max_pairs = 160;             ///< beyond it classes with many keep the most alike
};

/// The same-class node pairs of two graphs, and which of them agree: pairs (p, q), (p', q') of
/// different nodes whose distances d(p, p') and d(q, q') are equal within the nodes' noise.
class ConsistencyGraph {
 public:
  /// O(a² + n² + k²) for a same-class pairs of n and k nodes.
  template <typename Scalar>
  ConsistencyGraph(const TopologyGraph<Scalar>& candidate, const TopologyGraph<Scalar>& query,
                   const ConsistencyOptions& options)
      : ConsistencyGraph(candidate, detail::KnownDistances<Scalar>(query, options.noise), options) {
  }

  /// The same with a query that is compared with many: what is known of its distances stays known.
  template <typename Scalar>
  ConsistencyGraph(const TopologyGraph<Scalar>& candidate,
                   const detail::KnownDistances<Scalar>& query, const ConsistencyOptions& options)
      : complete_(true),
        pairs_(best_pairs(candidate, query.graph(), options, complete_)),
        agreement_(pairs_.size(), pairs_.size()),
        vertical_(shared_vertical(candidate, query.graph())),
        candidate_distances_(candidate, vertical_ ? &*candidate.gravity() : nullptr, options.noise),
        query_distances_(query.table(vertical_.has_value())) {
    points_.reserve(pairs_.size());
    query_of_.reserve(pairs_.size());
    for (const Correspondence& pair : pairs_) {
      points_.push_back(point_pair(candidate.node(pair.candidate), query.graph().node(pair.query),
                                   options.noise));
      query_of_.push_back(value(pair.query));
    }
    // Which pairs agree no branch could foretell: so there is none.
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
      const detail::Distance* p = candidate_distances_.row(value(pairs_[i].candidate));
      const detail::Distance* q = query_distances_->row(value(pairs_[i].query));
      for (std::size_t j = i + 1; j < pairs_.size(); ++j) {
        const bool other_query = pairs_[i].query != pairs_[j].query;
        const bool other_candidate = pairs_[i].candidate != pairs_[j].candidate;
        const bool alike = agree(p[value(pairs_[j].candidate)], q[value(pairs_[j].query)], options);
        const bool both = other_query & other_candidate & alike;
        agreement_.set_if(both, i, j);
        agreement_.set_if(both, j, i);
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
           length(*query_distances_, pairs_[i].query, pairs_[j].query);
  }

  /// The vertical, where both graphs know it.
  const std::optional<SharedVertical>& vertical() const noexcept { return vertical_; }

  /// False when `max_pairs` left pairs out.
  bool complete() const noexcept { return complete_; }

 private:
  template <typename Scalar>
  static std::vector<Correspondence> best_pairs(const TopologyGraph<Scalar>& candidate,
                                                const TopologyGraph<Scalar>& query,
                                                const ConsistencyOptions& options, bool& complete) {
    auto pairs = detail::offered_pairs(candidate, query, options);
    complete = pairs.size() <= options.max_pairs;
    if (!complete) detail::keep_telling(pairs, candidate, query, options.max_pairs);
    return pairs;
  }

  static bool agree(const detail::Distance& p, const detail::Distance& q,
                    const ConsistencyOptions& options) {
    const bool level = within_noise(p.length - q.length, p.variance + q.variance, options);
    const bool upright = within_noise(p.drop - q.drop, p.drop_variance + q.drop_variance, options);
    return level & upright;
  }

  static bool within_noise(double difference, double variance, const ConsistencyOptions& options) {
    const double size = std::abs(difference);
    return (size <= options.min_tolerance) |
           ((size <= options.max_tolerance) &
            (size * size <= options.deviations * options.deviations * variance));
  }

  bool complete_;
  std::vector<Correspondence> pairs_;
  std::vector<PointPair> points_;
  std::vector<std::size_t> query_of_;
  detail::BitMatrix agreement_;
  std::optional<SharedVertical> vertical_;
  detail::DistanceTable candidate_distances_;
  std::shared_ptr<const detail::DistanceTable> query_distances_;
};

}  // namespace v0
}  // namespace topobag
