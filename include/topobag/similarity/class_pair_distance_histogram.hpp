// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <topobag/graph/topology_graph.hpp>
#include <topobag/similarity/class_weights.hpp>
#include <topobag/similarity/detail/histogram_word.hpp>
#include <topobag/similarity/detail/soft_bins.hpp>
#include <topobag/similarity/sparse_histogram.hpp>

namespace topobag {
inline namespace v0 {

/// How often which two classes lie how far apart, and how large the objects are, as the Jaccard
/// index of two sparse histograms.
///
/// Every two nodes with a position vote for (their classes, their distance), softly between two
/// bins; every node votes for its class with its width and with its height where they are known,
/// and a little for its class alone, so that all graphs are comparable. Uses neither pixels nor
/// edges: unchanged by the camera's motion as long as the same objects look as large. Hydra's
/// distance histograms (Hughes, Chang, Carlone, RSS 2022), kept apart by the classes at both ends.
///
/// Descriptor O(n² log n); similarity O(n² + k²) at most, by one merge.
struct ClassPairDistanceHistogram {
  double bin_width = 0.15;    ///< m, > 0
  double max_distance = 5.0;  ///< m; farther pairs count as this far, < 2³² bin widths
  double class_vote = 0.1;    ///< of each node for its class, where a pair's vote is 1; > 0
  double size_vote = 1.0;     ///< of each node for each side of its box; 0 = sizes do not matter
  double size_bin = 0.4;      ///< octaves, > 0
  ClassWeights weights{};     ///< multiply a node's votes; a pair's by their geometric mean

  template <typename Scalar>
  SparseHistogram descriptor(const TopologyGraph<Scalar>& graph) const {
    std::vector<SparseHistogram::Entry> votes;
    const auto& nodes = graph.nodes();
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const auto& node = nodes[i];
      votes.push_back({detail::histogram_word(node.label), class_vote * weights(node.label)});
      vote_for_side(node.label, width, static_cast<double>(node.size.x()), votes);
      vote_for_side(node.label, height, static_cast<double>(node.size.y()), votes);
      if (!node.position) continue;
      for (std::size_t j = i + 1; j < nodes.size(); ++j) {
        if (!nodes[j].position) continue;
        const auto [low, high] = std::minmax(node.label, nodes[j].label);
        const double weight = std::sqrt(weights(low) * weights(high));
        const auto distance = static_cast<double>((*node.position - *nodes[j].position).norm());
        for (const auto& [bin, share] : detail::soft_bins(distance, bin_width, max_distance)) {
          votes.push_back({detail::histogram_word(low, high, bin), weight * share});
        }
      }
    }
    return SparseHistogram(std::move(votes));
  }

  double similarity(const SparseHistogram& p, const SparseHistogram& q) const {
    return jaccard(p, q);
  }

  template <typename Scalar>
  double operator()(const TopologyGraph<Scalar>& p, const TopologyGraph<Scalar>& q) const {
    return similarity(descriptor(p), descriptor(q));
  }

 private:
  static constexpr std::uint64_t width = 0, height = 1;

  /// A soft vote for the logarithm of one side of a node's box, m; none where it is not known.
  void vote_for_side(ClassId label, std::uint64_t side, double length,
                     std::vector<SparseHistogram::Entry>& votes) const {
    if (!(length > 0.0)) return;
    constexpr double smallest = 1e-3, max_octaves = 30.0;
    const double octaves = std::log2(std::max(length, smallest) / smallest);
    const double weight = size_vote * weights(label);
    // Words of four parts, so none is a pair's.
    for (const auto& [bin, share] : detail::soft_bins(octaves, size_bin, max_octaves)) {
      votes.push_back({detail::histogram_word(label, label, side, bin), weight * share});
    }
  }
};

}  // namespace v0
}  // namespace topobag
