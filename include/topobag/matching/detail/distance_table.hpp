// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include <Eigen/Core>

#include <topobag/graph/topology_graph.hpp>
#include <topobag/sensing/node_noise.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// How far two nodes lie apart and the variance of that, m and m². Where the vertical is known,
/// `length` is horizontal and `drop` the signed height that the second node lies below the first.
struct Distance {
  double length = 0.0;
  double variance = 0.0;
  double drop = 0.0;
  double drop_variance = 0.0;
};

/// The distances between the nodes of one graph, worked out once: each enters the comparison with
/// many distances of another graph. Zero where a node has no position.
class DistanceTable {
 public:
  /// @param vertical  the graph's, when distances are to be told by their horizontal and vertical
  /// parts; null for the whole distance
  /// @param unmodelled  the noise of a node that has no covariance
  /// O(n²).
  template <typename Scalar>
  explicit DistanceTable(const TopologyGraph<Scalar>& graph,
                         const Gravity<Scalar>* vertical = nullptr,
                         const NodeNoise& unmodelled = {})
      : size_(graph.size()), distances_(size_ * size_) {
    struct Placed {
      std::size_t node;
      Eigen::Vector3d position;
      Eigen::Matrix3d covariance;
    };
    std::vector<Placed> placed;
    placed.reserve(size_);
    for (std::size_t i = 0; i < size_; ++i) {
      const auto& node = graph.nodes()[i];
      if (!node.position) continue;
      const Placed here{i, node.position->template cast<double>(),
                        position_covariance(node, unmodelled)};
      for (const Placed& there : placed) {
        Distance distance =
            vertical ? level_distance(here, there, *vertical) : distance_between(here, there);
        distances_[i * size_ + there.node] = distance;
        distance.drop = -distance.drop;
        distances_[there.node * size_ + i] = distance;
      }
      placed.push_back(here);
    }
  }

  /// From node `i` to each node.
  const Distance* row(std::size_t i) const noexcept { return distances_.data() + i * size_; }

 private:
  template <typename Placed>
  static Distance distance_between(const Placed& a, const Placed& b) {
    const auto line = (a.position - b.position).eval();
    const auto covariance = (a.covariance + b.covariance).eval();
    const double length = line.norm();
    // Coincident nodes have no direction: the mean over all.
    if (!(length > 0.0)) return {length, covariance.trace() / 3.0};
    return {length, line.dot(covariance * line) / (length * length)};
  }

  /// From `a` to `b`; a tilt moves heights by the horizontal distance, and hardly that itself.
  template <typename Placed, typename Vertical>
  static Distance level_distance(const Placed& a, const Placed& b, const Vertical& vertical) {
    const Eigen::Vector3d down = vertical.down.template cast<double>();
    const Eigen::Matrix3d covariance = a.covariance + b.covariance;
    const Eigen::Vector3d line = b.position - a.position;
    const double drop = down.dot(line);
    const Eigen::Vector3d level = line - drop * down;
    const double length = level.norm();
    const double drop_variance = down.dot(covariance * down);
    const double variance = length > 0.0 ? level.dot(covariance * level) / (length * length)
                                         : (covariance.trace() - drop_variance) / 2.0;
    const double tilt = static_cast<double>(vertical.deviation) * length;
    return {length, variance, drop, drop_variance + tilt * tilt};
  }

  std::size_t size_;
  std::vector<Distance> distances_;
};

/// The tables of one graph that is compared with many, each worked out when it is first asked for.
/// Refers to the graph; one thread at a time.
template <typename Scalar>
class KnownDistances {
 public:
  /// @param unmodelled  the noise of a node that has no covariance
  KnownDistances(const TopologyGraph<Scalar>& graph, const NodeNoise& unmodelled)
      : graph_(graph), unmodelled_(unmodelled) {}

  const TopologyGraph<Scalar>& graph() const noexcept { return graph_; }

  /// @param level  horizontal and vertical parts; precondition: the graph knows its vertical
  std::shared_ptr<const DistanceTable> table(bool level) const {
    auto& known = level ? level_ : whole_;
    if (!known) {
      known = std::make_shared<const DistanceTable>(graph_, level ? &*graph_.gravity() : nullptr,
                                                    unmodelled_);
    }
    return known;
  }

 private:
  const TopologyGraph<Scalar>& graph_;
  NodeNoise unmodelled_;
  mutable std::shared_ptr<const DistanceTable> whole_, level_;
};

}  // namespace detail
}  // namespace v0
}  // namespace topobag
