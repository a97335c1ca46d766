// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <memory>
#include <utility>
#include <vector>

#include <topobag/bag/detail/index/best_candidates.hpp>
#include <topobag/bag/detail/index/common_mass.hpp>
#include <topobag/bag/detail/index/leaf_order.hpp>
#include <topobag/bag/search_result.hpp>
#include <topobag/graph/topology_graph.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// One query of one bag: visits leaves by falling bound, until no leaf can hold a better graph.
template <typename Similarity>
class BagSearch {
 public:
  BagSearch(const BagParts& parts, const Similarity& similarity, const TopologyGraph<double>& graph,
            const QueryOptions& options, std::size_t max_visited)
      : parts_(options.restricts() ? possible(parts, options.among) : parts),
        similarity_(similarity),
        options_(options),
        restricted_(options.restricts()),
        max_visited_(max_visited),
        query_(similarity.descriptor(graph)),
        coarse_query_(coarse_histogram(query_)),
        sketch_(coarse_query_),
        common_mass_(similarity, query_, labels_of(graph)),
        // Scores lie in [0, 1]: no other floor tells them apart, and the bounds' sums are not made
        // for one.
        best_(options.max_results, std::clamp(options.min_similarity, 0.0, 2.0)) {}

  SearchResult run() {
    visit_head();
    LeafOrder order(parts_, coarse_query_, query_.total());
    // Some good leaves first: they raise the floor, and then most leaves are not even sorted.
    visit(order.take_best(good_leaves));
    const double floor = std::max(0.0, best_.floor() - score_slack);
    visit(order.take_at_least(static_cast<float>(floor)));
    SearchResult result;
    result.candidates = best_.finish(parts_, [&](const StoredEntry& entry) {
      return similarity_.similarity(query_, similarity_.descriptor_of(scan_(entry.graph)));
    });
    result.entries = parts_.live;
    result.visited = visited_;
    result.missed_similarity = missed_;
    result.exact = missed_ == 0.0;
    return result;
  }

 private:
  static constexpr std::size_t good_leaves = 64;

  static BagParts possible(BagParts parts, const EntryFilter& among) {
    auto sealed = std::make_shared<BagParts::Sealed>();
    std::copy_if(parts.sealed->begin(), parts.sealed->end(), std::back_inserter(*sealed),
                 [&](const SealedPart& part) { return part.infos->range().may_pass(among); });
    parts.sealed = std::move(sealed);
    return parts;
  }

  static std::vector<ClassId> labels_of(const TopologyGraph<double>& graph) {
    std::vector<ClassId> labels;
    for (const auto& node : graph.nodes()) labels.push_back(node.label);
    return labels;
  }

  void visit_head() {
    const auto total = static_cast<float>(query_.total());
    for (std::size_t slot = 0; slot < parts_.head_size; ++slot) {
      if (parts_.dead_in_head[slot]) continue;
      const float stored = (*parts_.head)[slot].total;
      visit({parts_.sealed->size(), slot}, jaccard_bound(total, total, stored, stored));
    }
  }

  /// @param leaves  best first
  void visit(const std::vector<BoundedLeaf>& leaves) {
    for (const BoundedLeaf& leaf : leaves) {
      const auto bound = static_cast<double>(leaf.bound);
      if (!best_.wants(bound) || missed_ > bound) break;
      visit(leaf);
    }
  }

  void visit(const BoundedLeaf& leaf) {
    const auto total = static_cast<float>(query_.total());
    const SealedPart& part = (*parts_.sealed)[leaf.part];
    const Segment& segment = *part.segment;
    const std::size_t end = segment.leaf_end(leaf.leaf);
    for (std::size_t slot = segment.leaf_begin(leaf.leaf); slot < end; ++slot) {
      if (!part.is_live(slot)) continue;
      const float stored = segment.total(slot);
      if (falls_short(leaf.common, total + stored)) continue;
      const float common = std::min(leaf.common, sketch_.common(segment.sketch(slot)));
      if (falls_short(common, total + stored)) continue;
      visit({leaf.part, slot}, jaccard_bound(common, total, stored, stored));
    }
  }

  /// Whether the Jaccard index of two histograms, by what they have in common and the sum of their
  /// totals, is too low for certain: most are, and are passed over without a division.
  bool falls_short(float common, float totals) const noexcept {
    const auto floor = static_cast<float>(best_.floor() - 2.0 * score_slack);
    return common < floor * (totals - common);
  }

  /// @param rounded_bound  of the graph's score
  void visit(EntryPlace place, float rounded_bound) {
    const auto bound = static_cast<double>(rounded_bound);
    if (!best_.wants(bound)) return;
    const StoredEntry entry = parts_.entry(place);
    if (restricted_ && !options_.admits(entry.id, parts_.info(place))) return;
    if (!(bound > 0.0)) {
      best_.add_nothing_in_common(entry.id);
    } else if (visited_ == max_visited_) {
      missed_ = std::max(missed_, std::min(bound + score_slack, 1.0));
    } else {
      ++visited_;
      const double shared = common_mass_(scan_(entry.graph));
      best_.add(place, entry,
                similarity_of(shared, query_.total(), static_cast<double>(entry.total)));
    }
  }

  BagParts parts_;  ///< as far as they may hold what is asked for
  const Similarity& similarity_;
  const QueryOptions& options_;
  bool restricted_;
  std::size_t max_visited_;
  SparseHistogram query_;
  CoarseHistogram coarse_query_;
  SketchQuery sketch_;
  CommonMass<Similarity> common_mass_;
  NodeScan scan_;
  BestCandidates best_;
  std::size_t visited_ = 0;
  double missed_ = 0.0;
};

}  // namespace detail
}  // namespace v0
}  // namespace topobag
