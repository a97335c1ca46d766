// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include <topobag/graph/topology_graph.hpp>
#include <topobag/similarity/class_weights.hpp>
#include <topobag/similarity/detail/histogram_word.hpp>
#include <topobag/similarity/detail/neighbors.hpp>
#include <topobag/similarity/node_histograms.hpp>
#include <topobag/similarity/sparse_histogram.hpp>

namespace topobag {
inline namespace v0 {

/// What a surrounding-label histogram counts.
enum class Surroundings {
  neighbors,      ///< labels of the neighbours
  neighbor_pairs  ///< labels along every path of two edges
};

/// For each node the labels around it, compared by the best assignment within classes.
///
/// `neighbors` is GOReloc's descriptor (Wang, Jiang, Chen, RA-L 2024), which weighs each neighbour
/// by 1 − the frequency of its class: give such `weights`, or those of `ClassWeights::idf`.
/// `neighbor_pairs` is the semantic histogram of Guo et al. (RA-L 2021), which
/// counts each path (node, neighbour, its neighbour) and replaces random walks. Uses edges and
/// classes, neither pixels nor lengths. Descriptor O(n · degree²); similarity O(n k) cosines and
/// the assignment, O(n³) at worst.
struct SurroundingLabels {
  Surroundings counted = Surroundings::neighbors;  ///< which labels
  ClassWeights weights{};                          ///< of the counted labels

  template <typename Scalar>
  NodeHistograms descriptor(const TopologyGraph<Scalar>& graph) const {
    const auto neighbors = detail::neighbors(graph);
    const auto label = [&](std::size_t i) { return graph.nodes()[i].label; };
    std::vector<std::pair<ClassId, SparseHistogram>> nodes;
    for (std::size_t i = 0; i < graph.size(); ++i) {
      std::vector<SparseHistogram::Entry> votes;
      for (const std::size_t j : neighbors[i]) {
        if (counted == Surroundings::neighbors) {
          votes.push_back({detail::histogram_word(label(j)), weights(label(j))});
          continue;
        }
        for (const std::size_t k : neighbors[j]) {
          if (k == i) continue;
          votes.push_back(
              {detail::histogram_word(label(j), label(k)), weights(label(j)) * weights(label(k))});
        }
      }
      nodes.emplace_back(label(i), SparseHistogram(std::move(votes)));
    }
    return NodeHistograms(std::move(nodes));
  }

  double similarity(const NodeHistograms& p, const NodeHistograms& q) const {
    return assigned_cosine(p, q);
  }

  template <typename Scalar>
  double operator()(const TopologyGraph<Scalar>& p, const TopologyGraph<Scalar>& q) const {
    return similarity(descriptor(p), descriptor(q));
  }
};

}  // namespace v0
}  // namespace topobag
