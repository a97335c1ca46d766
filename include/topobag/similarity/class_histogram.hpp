// SPDX-License-Identifier: MIT
#pragma once

#include <utility>
#include <vector>

#include <topobag/graph/topology_graph.hpp>
#include <topobag/similarity/class_weights.hpp>
#include <topobag/similarity/detail/histogram_word.hpp>
#include <topobag/similarity/sparse_histogram.hpp>

namespace topobag {
inline namespace v0 {

/// How two class histograms are compared.
enum class HistogramMeasure {
  cosine,  ///< of the angle between them; with `ClassWeights::idf`: tf-idf
  jaccard  ///< Σ min / Σ max
};

/// How many nodes of each class there are, and nothing of where: the bag of words with objects for
/// words (Sivic and Zisserman, ICCV 2003).
///
/// Descriptor O(n log n); similarity O(classes of both).
struct ClassHistogram {
  HistogramMeasure measure = HistogramMeasure::jaccard;  ///< how two are compared
  ClassWeights weights{};                                ///< of the classes

  template <typename Scalar>
  SparseHistogram descriptor(const TopologyGraph<Scalar>& graph) const {
    std::vector<SparseHistogram::Entry> votes;
    for (const auto& node : graph.nodes()) {
      votes.push_back({detail::histogram_word(node.label), weights(node.label)});
    }
    const SparseHistogram histogram(std::move(votes));
    return measure == HistogramMeasure::cosine ? histogram.normalized() : histogram;
  }

  double similarity(const SparseHistogram& p, const SparseHistogram& q) const {
    return measure == HistogramMeasure::cosine ? unit_cosine(p, q) : jaccard(p, q);
  }

  template <typename Scalar>
  double operator()(const TopologyGraph<Scalar>& p, const TopologyGraph<Scalar>& q) const {
    return similarity(descriptor(p), descriptor(q));
  }
};

}  // namespace v0
}  // namespace topobag
