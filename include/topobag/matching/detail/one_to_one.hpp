// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include <topobag/matching/correspondence.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// Two nodes, and how far apart they are.
using Neighbors = std::pair<double, Correspondence>;

/// Adds pairs so that no node is in two, the closest first, ties by index. Returns all, ascending.
/// @param candidates, queries  numbers of nodes
/// O(n log n).
inline std::vector<Correspondence> with_closest(std::vector<Correspondence> pairs,
                                                std::vector<Neighbors> near, std::size_t candidates,
                                                std::size_t queries) {
  std::vector<bool> candidate_taken(candidates, false), query_taken(queries, false);
  const auto take = [&](const Correspondence& pair) {
    candidate_taken[value(pair.candidate)] = query_taken[value(pair.query)] = true;
  };
  for (const Correspondence& pair : pairs) take(pair);
  std::sort(near.begin(), near.end());
  for (const auto& [distance, pair] : near) {
    if (candidate_taken[value(pair.candidate)] || query_taken[value(pair.query)]) continue;
    take(pair);
    pairs.push_back(pair);
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace detail
}  // namespace v0
}  // namespace topobag
