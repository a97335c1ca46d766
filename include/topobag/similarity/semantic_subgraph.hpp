// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include <topobag/graph/topology_graph.hpp>
#include <topobag/sensing/sensor_profile.hpp>
#include <topobag/similarity/detail/assigned_gain.hpp>
#include <topobag/similarity/detail/histogram_word.hpp>
#include <topobag/similarity/detail/soft_bins.hpp>
#include <topobag/similarity/sparse_histogram.hpp>

namespace topobag {
inline namespace v0 {

/// Semantic sub-graphs matched by a sparse Kuhn–Munkres: box shape and distances in space together
/// (Qin, Zhang, Liu, Lv, J. Vis. Commun. Image Represent. 76, 2021; the paper's reference [25], of
/// which the formulas here are a reading).
///
/// A node's sub-graph is the classes of all nodes, itself included, at their distances from it in
/// space, softly binned. The gain
/// of two nodes of one class is (min/max of their widths) · (min/max of their heights) · (cosine of
/// their sub-graphs); pairs of different classes are not offered, which keeps the assignment
/// sparse. S is the largest total gain over max(n, k). An unknown size fits every size. Descriptor
/// O(n² log n); similarity O(n k) cosines and the assignment, O(n³) at worst.
struct SemanticSubgraph {
  double bin_width = 0.2;              ///< m, > 0
  double max_distance = layout_range;  ///< m; farther nodes count as this far, < 2³² bin widths

  /// One node: its class, its sub-graph (of length 1), its width and height (m).
  using Part = std::tuple<ClassId, SparseHistogram, double, double>;

  /// Parts in ascending order, labels parallel.
  struct Descriptor {
    std::vector<ClassId> labels;  ///< class of each part
    std::vector<Part> parts;      ///< one a node
  };

  template <typename Scalar>
  Descriptor descriptor(const TopologyGraph<Scalar>& graph) const {
    Descriptor result;
    const auto& nodes = graph.nodes();
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      std::vector<SparseHistogram::Entry> votes;
      for (std::size_t j = 0; j < nodes.size(); ++j) {
        if (!nodes[i].position || !nodes[j].position) continue;
        const auto distance = static_cast<double>((*nodes[i].position - *nodes[j].position).norm());
        for (const auto& [bin, share] : detail::soft_bins(distance, bin_width, max_distance)) {
          votes.push_back({detail::histogram_word(nodes[j].label, bin), share});
        }
      }
      result.parts.emplace_back(nodes[i].label, SparseHistogram(std::move(votes)).normalized(),
                                static_cast<double>(nodes[i].size.x()),
                                static_cast<double>(nodes[i].size.y()));
    }
    std::sort(result.parts.begin(), result.parts.end());
    for (const Part& part : result.parts) result.labels.push_back(std::get<ClassId>(part));
    return result;
  }

  double similarity(const Descriptor& p, const Descriptor& q) const {
    if (q.parts < p.parts) return similarity(q, p);
    if (p.parts.empty()) return 0.0;
    const double gained = detail::assigned_gain(
        p.labels, q.labels,
        [&](std::size_t i, std::size_t j) { return gain(p.parts[i], q.parts[j]); });
    return std::min(gained / static_cast<double>(std::max(p.parts.size(), q.parts.size())), 1.0);
  }

  template <typename Scalar>
  double operator()(const TopologyGraph<Scalar>& p, const TopologyGraph<Scalar>& q) const {
    return similarity(descriptor(p), descriptor(q));
  }

 private:
  static double gain(const Part& a, const Part& b) {
    const auto& [label_a, around_a, width_a, height_a] = a;
    const auto& [label_b, around_b, width_b, height_b] = b;
    const double layout =
        around_a.empty() && around_b.empty() ? 1.0 : unit_cosine(around_a, around_b);
    return ratio(width_a, width_b) * ratio(height_a, height_b) * layout;
  }

  static double ratio(double a, double b) {
    if (!(a > 0.0) || !(b > 0.0)) return 1.0;
    return std::min(a, b) / std::max(a, b);
  }
};

}  // namespace v0
}  // namespace topobag
