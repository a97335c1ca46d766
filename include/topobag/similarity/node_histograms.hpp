// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

#include <topobag/similarity/class_weights.hpp>
#include <topobag/similarity/detail/assigned_gain.hpp>
#include <topobag/similarity/sparse_histogram.hpp>
#include <topobag/types/ids.hpp>

namespace topobag {
inline namespace v0 {

/// The descriptor of similarities that assign nodes to nodes: a class and a histogram of length 1
/// (or empty) for each node, in an order that does not depend on the nodes'.
class NodeHistograms {
 public:
  NodeHistograms() = default;

  /// O(n log n).
  explicit NodeHistograms(std::vector<std::pair<ClassId, SparseHistogram>> nodes) {
    std::sort(nodes.begin(), nodes.end());
    for (auto& [label, histogram] : nodes) {
      labels_.push_back(label);
      histograms_.push_back(histogram.normalized());
    }
  }

  /// Ascending.
  const std::vector<ClassId>& labels() const noexcept { return labels_; }
  /// Parallel to `labels()`.
  const std::vector<SparseHistogram>& histograms() const noexcept { return histograms_; }

  friend bool operator<(const NodeHistograms& l, const NodeHistograms& r) noexcept {
    return std::tie(l.labels_, l.histograms_) < std::tie(r.labels_, r.histograms_);
  }

 private:
  std::vector<ClassId> labels_;
  std::vector<SparseHistogram> histograms_;
};

/// The repaired form of eq. 12: the best one-to-one assignment of the nodes within each class, the
/// weighted mean of the cosines of their histograms over the heavier graph's nodes:
/// Σ w_c cos / max(Σ_P w_c, Σ_Q w_c). Two empty histograms are alike. In [0, 1]; 0 for a graph
/// without weight. O(Σ r²c) over the classes, r ≤ c their nodes in the two graphs.
inline double assigned_cosine(const NodeHistograms& p, const NodeHistograms& q,
                              const ClassWeights& weights = {}) {
  if (q < p) return assigned_cosine(q, p, weights);
  const auto weight_of = [&](const NodeHistograms& graph) {
    double sum = 0.0;
    for (const ClassId label : graph.labels()) sum += weights(label);
    return sum;
  };
  const double heavier = std::max(weight_of(p), weight_of(q));
  if (!(heavier > 0.0)) return 0.0;
  const double gained =
      detail::assigned_gain(p.labels(), q.labels(), [&](std::size_t i, std::size_t j) {
        const SparseHistogram& a = p.histograms()[i];
        const SparseHistogram& b = q.histograms()[j];
        const double cosine = a.empty() && b.empty() ? 1.0 : unit_cosine(a, b);
        return weights(p.labels()[i]) * cosine;
      });
  return std::min(gained / heavier, 1.0);
}

}  // namespace v0
}  // namespace topobag
