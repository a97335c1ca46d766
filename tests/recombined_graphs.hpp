// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

#include <topobag/edges/knn_edges.hpp>
#include <topobag/graph/topology_graph.hpp>

/// Endless key frames of made-up places, out of pieces of given graphs. The same on every machine
/// whose library has the same `std::mt19937_64`; the numbers drawn from it are made here.
///
/// A place is six in ten of the nodes of one graph and of another, which is turned about the
/// vertical and moved a metre or so; then every node is moved by some 30 cm. A key frame of it
/// lacks three nodes in twenty; the others are off by 2 to 3 cm and 5 % in size.
class RecombinedGraphs {
 public:
  using Graph = topobag::TopologyGraph<>;
  using Nodes = std::vector<Graph::Node>;

  RecombinedGraphs(std::vector<Graph> pieces, std::uint64_t seed) : random_(seed) {
    for (Graph& piece : pieces) {
      if (piece.is_matchable()) pieces_.push_back(std::move(piece));
    }
  }

  Nodes place() {
    Nodes nodes;
    while (nodes.size() < 3) {
      nodes.clear();
      for (const auto& node : piece().nodes()) {
        if (chance(0.6)) nodes.push_back(node);
      }
      const Graph& other = piece();
      const double angle = 6.283185307179586 * unit();
      const Eigen::AngleAxisd turn(angle, Eigen::Vector3d::UnitY());
      const Eigen::Vector3d shift(normal(), 0.0, 3.0 + normal());
      for (auto node : other.nodes()) {
        if (!chance(0.6)) continue;
        if (node.position) *node.position = turn * (*node.position - center(other)) + shift;
        nodes.push_back(node);
      }
      for (auto& node : nodes) move(node, 0.3, 0.1, 0.3);
    }
    return nodes;
  }

  Graph keyframe(const Nodes& place) {
    Nodes nodes;
    while (nodes.size() < 3) {
      nodes.clear();
      for (auto node : place) {
        if (chance(0.15)) continue;
        move(node, 0.02, 0.02, 0.03);
        node.size *= std::exp(0.05 * normal());
        if (node.position) node.z = node.position->z();
        nodes.push_back(std::move(node));
      }
    }
    return topobag::make_topology_graph(std::move(nodes), topobag::KnnEdges{});
  }

  /// Of 0 to n − 1.
  std::size_t below(std::size_t n) { return static_cast<std::size_t>(random_() % n); }
  double unit() { return static_cast<double>(random_() >> 11U) * 0x1p-53; }
  bool chance(double p) { return unit() < p; }

 private:
  const Graph& piece() { return pieces_[below(pieces_.size())]; }

  /// Nearly normal: the sum of twelve.
  double normal() {
    double sum = -6.0;
    for (int i = 0; i < 12; ++i) sum += unit();
    return sum;
  }

  void move(Graph::Node& node, double x, double y, double z) {
    const Eigen::Vector3d by(x * normal(), y * normal(), z * normal());
    if (node.position) *node.position += by;
  }

  static Eigen::Vector3d center(const Graph& graph) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    double placed = 0.0;
    for (const auto& node : graph.nodes()) {
      if (!node.position) continue;
      sum += *node.position;
      placed += 1.0;
    }
    return sum / placed;
  }

  std::mt19937_64 random_;
  std::vector<Graph> pieces_;
};
