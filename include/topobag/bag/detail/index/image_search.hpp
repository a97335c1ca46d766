// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include <topobag/bag/detail/index/best_candidates.hpp>
#include <topobag/bag/detail/index/coarse_histogram.hpp>
#include <topobag/bag/detail/index/common_mass.hpp>
#include <topobag/bag/detail/index/leaf_order.hpp>
#include <topobag/bag/detail/index/sketch.hpp>
#include <topobag/bag/search_result.hpp>
#include <topobag/graph/topology_graph.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// One query of one bag whose score counts the images in: compares the image with every entry's,
/// and reads graphs by falling bound of the whole score until none can be better.
template <typename Similarity>
class ImageSearch {
 public:
  ImageSearch(const BagParts& parts, const Similarity& similarity,
              const TopologyGraph<double>& graph, const QueryOptions& options,
              std::size_t max_visited)
      : parts_(parts),
        similarity_(similarity),
        options_(options),
        max_visited_(max_visited),
        query_(similarity.descriptor(graph)),
        sketch_(coarse_histogram(query_)),
        common_mass_(similarity, query_, labels_of(graph)),
        best_(options.max_results, std::clamp(options.min_similarity, 0.0, 2.0)) {}

  /// O(n · length of the descriptors + graphs read · log n).
  SearchResult run() {
    std::vector<Bounded> order = bounded_entries();  // a heap: the best is read first
    std::make_heap(order.begin(), order.end());
    for (auto end = order.end(); end != order.begin(); --end) {
      if (!best_.wants(order.front().bound) || missed_ > order.front().bound) break;
      std::pop_heap(order.begin(), end);
      visit(*(end - 1));
    }
    SearchResult result;
    result.candidates = best_.finish(
        parts_,
        [&](const StoredEntry& entry) {
          return similarity_.similarity(query_, similarity_.descriptor_of(scan_(entry.graph)));
        },
        [&](EntryPlace place, double graphs) {
          return options_.image.score(graphs, parts_.image(place));
        });
    result.entries = parts_.live;
    result.visited = visited_;
    result.missed_similarity = missed_;
    result.exact = missed_ == 0.0;
    return result;
  }

 private:
  struct Bounded {
    double bound;  ///< of the score
    EntryPlace place;
    friend bool operator<(const Bounded& l, const Bounded& r) noexcept { return l.bound < r.bound; }
  };

  static std::vector<ClassId> labels_of(const TopologyGraph<double>& graph) {
    std::vector<ClassId> labels;
    for (const auto& node : graph.nodes()) labels.push_back(node.label);
    return labels;
  }

  /// How alike the graphs can be at most.
  float graph_bound(EntryPlace place) const {
    const auto total = static_cast<float>(query_.total());
    const float stored = parts_.entry(place).total;
    const float common =
        place.part == parts_.sealed->size()
            ? total
            : sketch_.common((*parts_.sealed)[place.part].segment->sketch(place.slot));
    return jaccard_bound(common, total, stored, stored);
  }

  std::vector<Bounded> bounded_entries() const {
    std::vector<Bounded> all;
    all.reserve(parts_.live);
    const bool restricted = options_.restricts();
    parts_.for_each([&](EntryPlace place) {
      if (restricted && !options_.admits(parts_.entry(place).id, parts_.info(place))) return;
      const auto graphs = static_cast<double>(graph_bound(place));
      const double bound = options_.image.score(graphs, parts_.image(place));
      if (best_.wants(bound)) all.push_back({bound, place});
    });
    return all;
  }

  void visit(const Bounded& entry) {
    const StoredEntry stored = parts_.entry(entry.place);
    if (!(entry.bound > 0.0)) {
      best_.add_nothing_in_common(stored.id);
    } else if (visited_ == max_visited_) {
      missed_ = std::max(missed_, std::min(entry.bound + score_slack, 1.0));
    } else {
      ++visited_;
      const double shared = common_mass_(scan_(stored.graph));
      const double graphs =
          similarity_of(shared, query_.total(), static_cast<double>(stored.total));
      best_.add(entry.place, stored, options_.image.score(graphs, parts_.image(entry.place)));
    }
  }

  const BagParts& parts_;
  const Similarity& similarity_;
  const QueryOptions& options_;
  std::size_t max_visited_;
  SparseHistogram query_;
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
