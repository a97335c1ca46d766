// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include <topobag/graph/topology_graph.hpp>
#include <topobag/sensing/node_noise.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// How far two nodes lie apart, m, and the variance of that, m².
struct Distance {
  double length = 0.0;
  double variance = 0.0;
};

/// The distances between the nodes of one graph, worked out once: each enters the comparison with
/// many distances of another graph. Zero where a node has no position.
class DistanceTable {
 public:
  /// O(n²).
  template <typename Scalar>
  explicit DistanceTable(const TopologyGraph<Scalar>& graph)
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
      const Placed here{i, node.position->template cast<double>(), position_covariance(node)};
      for (const Placed& there : placed) {
        const Distance distance = distance_between(here, there);
        distances_[i * size_ + there.node] = distance;
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

  std::size_t size_;
  std::vector<Distance> distances_;
};

}  // namespace detail
}  // namespace v0
}  // namespace topobag
