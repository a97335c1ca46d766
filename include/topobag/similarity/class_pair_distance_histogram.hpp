// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <topobag/graph/topology_graph.hpp>
#include <topobag/sensing/sensor_profile.hpp>
#include <topobag/similarity/class_weights.hpp>
#include <topobag/similarity/detail/histogram_word.hpp>
#include <topobag/similarity/detail/soft_bins.hpp>
#include <topobag/similarity/similarity.hpp>
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
  double bin_width = 0.15;             ///< m, > 0
  double max_distance = layout_range;  ///< m; farther pairs count as this far, < 2³² bin widths
  double class_vote = 0.1;  ///< of each node for its class, where a pair's vote is 1; > 0
  double size_vote = 1.0;   ///< of each node for each side of its box; 0 = sizes do not matter
  double size_bin = 0.4;    ///< octaves, > 0
  ClassWeights weights{};   ///< multiply a node's votes; a pair's by their geometric mean

  template <typename Scalar>
  SparseHistogram descriptor(const TopologyGraph<Scalar>& graph) const {
    return descriptor_of(graph.nodes());
  }

  /// The same from the nodes alone, or from anything with their `label`, `size` and `position`.
  template <typename Node>
  SparseHistogram descriptor_of(const std::vector<Node>& nodes) const {
    std::vector<SparseHistogram::Entry> votes;
    for_each_vote(nodes, [&](std::uint64_t word, double weight) {
      votes.push_back({word, weight});
    });
    return SparseHistogram(std::move(votes));
  }

  /// Calls `visit(word, weight)` for every vote; their sums per word are the descriptor. O(n²).
  template <typename Node, typename Visit>
  void for_each_vote(const std::vector<Node>& nodes, const Visit& visit) const {
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const Node& node = nodes[i];
      const double weight = weights(node.label);
      visit(class_word(node.label), class_vote * weight);
      const double sides[] = {static_cast<double>(node.size.x()),
                              static_cast<double>(node.size.y())};
      for (std::uint64_t side = 0; side < 2; ++side) {
        if (!(sides[side] > 0.0)) continue;
        const std::uint64_t words = side_words(node.label, side);
        for (const auto& [bin, share] : side_bins(octaves(sides[side]))) {
          visit(detail::next_word(words, bin), size_vote * weight * share);
        }
      }
      if (!node.position) continue;
      for (std::size_t j = i + 1; j < nodes.size(); ++j) {
        if (!nodes[j].position) continue;
        const auto [low, high] = std::minmax(node.label, nodes[j].label);
        const double vote = pair_vote(low, high);
        const std::uint64_t words = pair_words(low, high);
        const auto distance = static_cast<double>((*node.position - *nodes[j].position).norm());
        for (const auto& [bin, share] : distance_bins(distance)) {
          visit(detail::next_word(words, bin), vote * share);
        }
      }
    }
  }

  /// The word that stands for a class alone.
  static std::uint64_t class_word(ClassId label) { return detail::histogram_word(label); }
  /// What the words of a pair of classes have before the bin of its distance; `low` <= `high`.
  static std::uint64_t pair_words(ClassId low, ClassId high) {
    return detail::word_prefix<3>(low, high);
  }
  /// What the words of a side of a class's boxes have before the bin of its length: words of four
  /// parts, so that none is a pair's.
  static std::uint64_t side_words(ClassId label, std::uint64_t side) {
    return detail::word_prefix<4>(label, label, side);
  }
  /// The weight of a pair's vote.
  double pair_vote(ClassId a, ClassId b) const { return std::sqrt(weights(a) * weights(b)); }

  /// Between which bins a pair `distance` m apart votes.
  std::array<detail::SoftBin, 2> distance_bins(double distance) const {
    return detail::soft_bins(distance, bin_width, max_distance);
  }

  /// A side's length, m, as the bins count it: octaves above a millimetre.
  static double octaves(double length) {
    constexpr double smallest = 1e-3;
    return std::log2(std::max(length, smallest) / smallest);
  }

  /// Between which bins a side of so many `octaves` votes.
  std::array<detail::SoftBin, 2> side_bins(double octaves_of_side) const {
    return detail::soft_bins(octaves_of_side, size_bin, 30.0);
  }

  double similarity(const SparseHistogram& p, const SparseHistogram& q) const {
    return jaccard(p, q);
  }

  template <typename Scalar>
  double operator()(const TopologyGraph<Scalar>& p, const TopologyGraph<Scalar>& q) const {
    return similarity(descriptor(p), descriptor(q));
  }
};

/// By a merge of two histograms.
template <>
inline constexpr bool is_jaccard_v<ClassPairDistanceHistogram> = true;

}  // namespace v0
}  // namespace topobag
