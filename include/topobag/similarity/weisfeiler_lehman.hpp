// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <topobag/error.hpp>
#include <topobag/graph/topology_graph.hpp>
#include <topobag/similarity/detail/histogram_word.hpp>
#include <topobag/similarity/detail/neighbors.hpp>
#include <topobag/similarity/sparse_histogram.hpp>

namespace topobag {
inline namespace v0 {

/// The Weisfeiler–Lehman subtree kernel (Shervashidze et al., JMLR 12, 2011, section 3.2),
/// normalised: the cosine of the counts of all labels met while every node's label is replaced
/// `iterations` times by one for (its label, its neighbours' labels as a multiset).
///
/// Uses edges and classes, neither pixels nor lengths. Descriptor O(iterations · m log n);
/// similarity O(iterations · (n + k)).
struct WeisfeilerLehman {
  static constexpr std::size_t max_iterations = 1000;  ///< each takes room for all nodes

  std::size_t iterations = 1;  ///< 0 gives the class counts alone

  /// Throws InvalidValue for more than `max_iterations`.
  template <typename Scalar>
  SparseHistogram descriptor(const TopologyGraph<Scalar>& graph) const {
    if (iterations > max_iterations) {
      throw InvalidValue(std::to_string(iterations) +
                         " iterations over a graph's labels; at most " +
                         std::to_string(max_iterations) + " are counted");
    }
    const auto neighbors = detail::neighbors(graph);
    std::vector<std::uint64_t> labels;
    for (const auto& node : graph.nodes()) labels.push_back(detail::histogram_word(node.label));
    std::vector<SparseHistogram::Entry> votes;
    for (std::size_t iteration = 0;; ++iteration) {
      for (const std::uint64_t label : labels) votes.push_back({label, 1.0});
      if (iteration == iterations) break;
      labels = refined(labels, neighbors);
    }
    return SparseHistogram(std::move(votes)).normalized();
  }

  double similarity(const SparseHistogram& p, const SparseHistogram& q) const {
    return unit_cosine(p, q);
  }

  template <typename Scalar>
  double operator()(const TopologyGraph<Scalar>& p, const TopologyGraph<Scalar>& q) const {
    return similarity(descriptor(p), descriptor(q));
  }

 private:
  static std::vector<std::uint64_t> refined(
      const std::vector<std::uint64_t>& labels,
      const std::vector<std::vector<std::size_t>>& neighbors) {
    std::vector<std::uint64_t> next;
    std::vector<std::uint64_t> around;
    for (std::size_t i = 0; i < labels.size(); ++i) {
      around.clear();
      for (const std::size_t j : neighbors[i]) around.push_back(labels[j]);
      std::sort(around.begin(), around.end());
      std::uint64_t word = detail::histogram_word(labels[i], std::uint64_t{around.size()});
      for (const std::uint64_t label : around) word = detail::histogram_word(word, label);
      next.push_back(word);
    }
    return next;
  }
};

}  // namespace v0
}  // namespace topobag
