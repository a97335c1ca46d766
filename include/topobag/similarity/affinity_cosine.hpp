// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include <topobag/assert.hpp>
#include <topobag/graph/topology_graph.hpp>
#include <topobag/similarity/class_vectors.hpp>
#include <topobag/similarity/class_weights.hpp>
#include <topobag/similarity/node_histograms.hpp>
#include <topobag/similarity/sparse_histogram.hpp>

namespace topobag {
inline namespace v0 {

/// The paper's similarity repaired: W = A · C in place of W = D · O (eq. 9, 10).
///
/// C holds a vector for each node's class and no pixels, so no column depends on the camera, and no
/// class is a multiple of another. A holds e^{−d_ij / σ} where D of eq. 8 holds d_ij, so near
/// neighbours count more, not less, than far ones and than none; its diagonal stays 1. Rows are
/// assigned within classes instead of compared by index, and their mean is weighted by class.
///
/// Descriptor O(n + m) class vectors; similarity O(n k) cosines and the assignment, O(n³) at worst.
struct AffinityCosine {
  double sigma = 0.6;      ///< m, > 0; distance over which an edge loses 1 − 1/e of its weight
  ClassVectors vectors{};  ///< C
  ClassWeights weights{};  ///< of the classes

  template <typename Scalar>
  NodeHistograms descriptor(const TopologyGraph<Scalar>& graph) const {
    TOPOBAG_ASSERT(sigma > 0.0);
    std::vector<std::vector<SparseHistogram::Entry>> rows(graph.size());
    const auto add = [&](NodeIndex row, NodeIndex other, double affinity) {
      const SparseHistogram vector = vectors(graph.node(other).label);
      for (const auto& [word, weight] : vector.entries()) {
        rows[value(row)].push_back({word, affinity * weight});
      }
    };
    for (std::size_t i = 0; i < graph.size(); ++i) add(node_index(i), node_index(i), 1.0);
    for (std::size_t e = 0; e < graph.edges().size(); ++e) {
      const auto [a, b] = graph.edges()[e];
      const double affinity = std::exp(-static_cast<double>(graph.lengths()[e]) / sigma);
      add(a, b, affinity);
      add(b, a, affinity);
    }
    std::vector<std::pair<ClassId, SparseHistogram>> nodes;
    for (std::size_t i = 0; i < graph.size(); ++i) {
      nodes.emplace_back(graph.nodes()[i].label, SparseHistogram(std::move(rows[i])));
    }
    return NodeHistograms(std::move(nodes));
  }

  double similarity(const NodeHistograms& p, const NodeHistograms& q) const {
    return assigned_cosine(p, q, weights);
  }

  template <typename Scalar>
  double operator()(const TopologyGraph<Scalar>& p, const TopologyGraph<Scalar>& q) const {
    return similarity(descriptor(p), descriptor(q));
  }
};

}  // namespace v0
}  // namespace topobag
