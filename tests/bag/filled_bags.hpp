// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include <topobag/bag/bag_of_topology_graphs.hpp>
#include <topobag/bag/indexed_bag.hpp>
#include <topobag/similarity/class_pair_distance_histogram.hpp>
#include <topobag/similarity/similarity.hpp>

#include "recombined_graphs.hpp"

/// The default's, of which the bag does not know that it is a Jaccard index.
struct UnknownSimilarity : topobag::ClassPairDistanceHistogram {};

/// Compares a query with every graph.
using BruteForceBag = topobag::BagOfTopologyGraphs<topobag::TopologyGraph<>, UnknownSimilarity>;
static_assert(!topobag::is_jaccard_v<UnknownSimilarity>);

/// Key frames of `places` places, ten of each in a row, under the ids 0, 1, …
inline topobag::IndexedBag bag_of(RecombinedGraphs& source, std::size_t places) {
  topobag::IndexedBag bag;
  for (std::size_t p = 0; p < places; ++p) {
    const auto place = source.place();
    for (std::size_t i = 0; i < 10; ++i) {
      bag.add(topobag::KeyframeId{10 * p + i}, source.keyframe(place));
    }
  }
  return bag;
}

/// The same entries, to be asked one by one.
inline BruteForceBag brute_force_of(const topobag::IndexedBag& bag,
                                    const topobag::ClassPairDistanceHistogram& similarity = {}) {
  BruteForceBag all(UnknownSimilarity{similarity});
  bag.for_each([&](topobag::KeyframeId id, const topobag::EntryInfo& info,
                   const topobag::TopologyGraph<>& graph) { all.add(id, graph, info); });
  return all;
}
