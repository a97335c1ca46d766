// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <utility>
#include <vector>

#include <topobag/graph/topology_graph.hpp>
#include <topobag/sensing/sensor_profile.hpp>
#include <topobag/similarity/detail/histogram_word.hpp>
#include <topobag/similarity/detail/soft_bins.hpp>
#include <topobag/similarity/similarity.hpp>
#include <topobag/similarity/sparse_histogram.hpp>

namespace topobag {
inline namespace v0 {

/// Which classes stand at the corners of triangles with which sides: the hashed triangles of STD
/// (Yuan et al., ICRA 2023) with classes at the corners.
///
/// Every three nodes with a position vote for (class, opposite side) of each corner, softly between
/// two bins of each side; every node votes a little for its class, so that graphs without three
/// positions are comparable. Uses neither pixels nor edges. Descriptor O(n³ log n); similarity O(n³
/// + k³) at most, by a merge.
struct ClassTriangles {
  double bin_width = 0.6;              ///< m, > 0
  double max_distance = layout_range;  ///< m; longer sides count as this long, < 2³² bin widths
  double class_vote = 0.1;  ///< of each node for its class, where a triangle's vote is 1; > 0

  template <typename Scalar>
  SparseHistogram descriptor(const TopologyGraph<Scalar>& graph) const {
    std::vector<SparseHistogram::Entry> votes;
    std::vector<const SemanticNode<Scalar>*> placed;
    for (const auto& node : graph.nodes()) {
      votes.push_back({detail::histogram_word(node.label), class_vote});
      if (node.position) placed.push_back(&node);
    }
    const auto bins = [&](std::size_t i, std::size_t j) {
      const auto side = (*placed[i]->position - *placed[j]->position).norm();
      return detail::soft_bins(static_cast<double>(side), bin_width, max_distance);
    };
    for (std::size_t i = 0; i < placed.size(); ++i) {
      for (std::size_t j = i + 1; j < placed.size(); ++j) {
        for (std::size_t k = j + 1; k < placed.size(); ++k) {
          vote({placed[i]->label, placed[j]->label, placed[k]->label},
               {bins(j, k), bins(i, k), bins(i, j)}, votes);
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
  using Bins = std::array<detail::SoftBin, 2>;

  /// One triangle's vote, shared out over the eight combinations of its sides' bins.
  static void vote(const std::array<ClassId, 3>& labels, const std::array<Bins, 3>& opposite,
                   std::vector<SparseHistogram::Entry>& votes) {
    for (const auto& [bin_0, share_0] : opposite[0]) {
      for (const auto& [bin_1, share_1] : opposite[1]) {
        for (const auto& [bin_2, share_2] : opposite[2]) {
          // Sorted with their shares, so that the product does not depend on the nodes' order.
          std::array<std::tuple<ClassId, std::uint64_t, double>, 3> corners{
              {{labels[0], bin_0, share_0},
               {labels[1], bin_1, share_1},
               {labels[2], bin_2, share_2}}};
          std::sort(corners.begin(), corners.end());
          const auto& [label_a, bin_a, share_a] = corners[0];
          const auto& [label_b, bin_b, share_b] = corners[1];
          const auto& [label_c, bin_c, share_c] = corners[2];
          votes.push_back({detail::histogram_word(label_a, bin_a, label_b, bin_b, label_c, bin_c),
                           share_a * share_b * share_c});
        }
      }
    }
  }
};

/// By a merge of two histograms.
template <>
inline constexpr bool is_jaccard_v<ClassTriangles> = true;

}  // namespace v0
}  // namespace topobag
