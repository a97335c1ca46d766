// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include <topobag/graph/topology_graph.hpp>
#include <topobag/similarity/detail/histogram_word.hpp>
#include <topobag/similarity/detail/soft_bins.hpp>
#include <topobag/similarity/sparse_histogram.hpp>

namespace topobag {
inline namespace v0 {

/// How often which two classes lie how far apart, as the cosine of two sparse histograms.
///
/// Every two nodes with a position vote for (their classes, their distance), softly between two
/// bins; every node votes a little for its class, so that graphs without two positions are
/// comparable. Uses neither pixels nor edges: unchanged by the camera's motion as long as the same
/// objects are seen, and by the order of the nodes. The distances of Hydra's object descriptors
/// (Hughes, Chang, Carlone, RSS 2022) with the classes of both ends.
///
/// Descriptor O(n² log n); similarity O(n² + k²) at most, by a merge.
struct ClassPairDistanceHistogram {
  double bin_width = 0.2;     ///< m, > 0
  double max_distance = 5.0;  ///< m; farther pairs count as this far, < 2³² bin widths
  double class_vote = 0.1;    ///< of each node for its class, where a pair's vote is 1; > 0

  template <typename Scalar>
  SparseHistogram descriptor(const TopologyGraph<Scalar>& graph) const {
    std::vector<SparseHistogram::Entry> votes;
    const auto& nodes = graph.nodes();
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      votes.push_back({detail::histogram_word(nodes[i].label), class_vote});
      if (!nodes[i].position) continue;
      for (std::size_t j = i + 1; j < nodes.size(); ++j) {
        if (!nodes[j].position) continue;
        const auto [low, high] = std::minmax(nodes[i].label, nodes[j].label);
        const auto distance = static_cast<double>((*nodes[i].position - *nodes[j].position).norm());
        for (const auto& [bin, share] : detail::soft_bins(distance, bin_width, max_distance)) {
          votes.push_back({detail::histogram_word(low, high, bin), share});
        }
      }
    }
    return SparseHistogram(std::move(votes)).normalized();
  }

  double similarity(const SparseHistogram& p, const SparseHistogram& q) const noexcept {
    return unit_cosine(p, q);
  }

  template <typename Scalar>
  double operator()(const TopologyGraph<Scalar>& p, const TopologyGraph<Scalar>& q) const {
    return similarity(descriptor(p), descriptor(q));
  }
};

}  // namespace v0
}  // namespace topobag
