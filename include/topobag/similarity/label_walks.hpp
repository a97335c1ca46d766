// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <topobag/error.hpp>
#include <topobag/graph/topology_graph.hpp>
#include <topobag/similarity/class_weights.hpp>
#include <topobag/similarity/detail/histogram_word.hpp>
#include <topobag/similarity/detail/neighbors.hpp>
#include <topobag/similarity/node_histograms.hpp>
#include <topobag/similarity/sparse_histogram.hpp>

namespace topobag {
inline namespace v0 {

/// Random-walk descriptors: for each node the labels that random walks from it pass (Gawel et
/// al., X-View, RA-L 2018; the paper's reference [24] uses them too), compared by the best
/// assignment within classes.
///
/// The walks are not drawn: the descriptor holds each string of at most `length` labels with the
/// probability that an unbiased walk begins with it, which is what ever more draws tend to. Uses
/// edges and classes, neither pixels nor lengths. Descriptor O(n · degree^(length − 1)); similarity
/// O(n k) cosines and the assignment, O(n³) at worst.
struct LabelWalks {
  static constexpr std::size_t max_length = 16;  ///< beyond it walks are more than can be listed

  std::size_t length = 3;  ///< nodes of a walk, its start included; 1 to `max_length`
  ClassWeights weights{};  ///< of the classes

  /// Throws InvalidValue for a length out of range.
  template <typename Scalar>
  NodeHistograms descriptor(const TopologyGraph<Scalar>& graph) const {
    if (length < 1 || length > max_length) {
      throw InvalidValue("walks of " + std::to_string(length) + " nodes; 1 to " +
                         std::to_string(max_length) + " can be listed");
    }
    const Walker<Scalar> walker{graph, detail::neighbors(graph), length};
    std::vector<std::pair<ClassId, SparseHistogram>> nodes;
    for (std::size_t i = 0; i < graph.size(); ++i) {
      std::vector<SparseHistogram::Entry> votes;
      walker.walk(i, 0, 1.0, 1, votes);
      nodes.emplace_back(graph.nodes()[i].label, SparseHistogram(std::move(votes)));
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

 private:
  template <typename Scalar>
  struct Walker {
    const TopologyGraph<Scalar>& graph;
    std::vector<std::vector<std::size_t>> neighbors;
    std::size_t length;

    /// Votes for every walk that goes on from `node`, the `step`-th, after the string `word`.
    void walk(std::size_t node, std::uint64_t word, double probability, std::size_t step,
              std::vector<SparseHistogram::Entry>& votes) const {
      word = detail::histogram_word(word, graph.nodes()[node].label);
      votes.push_back({word, probability});
      if (step >= length) return;
      const double share = probability / static_cast<double>(neighbors[node].size());
      for (const std::size_t next : neighbors[node]) walk(next, word, share, step + 1, votes);
    }
  };
};

}  // namespace v0
}  // namespace topobag
