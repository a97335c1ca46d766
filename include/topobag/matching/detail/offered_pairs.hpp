// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include <topobag/graph/topology_graph.hpp>
#include <topobag/matching/class_groups.hpp>
#include <topobag/matching/correspondence.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// How many times larger the diagonal of one object is than the other's; 1 where one is unknown
/// (0).
template <typename Node>
double size_ratio(const Node& a, const Node& b) {
  const double size_a = static_cast<double>(a.size.norm());
  const double size_b = static_cast<double>(b.size.norm());
  if (size_a <= 0.0 || size_b <= 0.0) return 1.0;
  return std::max(size_a, size_b) / std::min(size_a, size_b);
}

/// The pairs of nodes with positions that may be one object: of one group of classes, and of about
/// the same size. Sorted by query node, then candidate node. O(n · k).
template <typename Scalar>
std::vector<Correspondence> offered_pairs(const TopologyGraph<Scalar>& candidate,
                                          const TopologyGraph<Scalar>& query,
                                          const ClassGroups& classes, double max_size_ratio) {
  std::vector<Correspondence> pairs;
  pairs.reserve(candidate.size() + query.size());
  std::vector<ClassId> candidate_groups;
  candidate_groups.reserve(candidate.size());
  for (const auto& node : candidate.nodes()) candidate_groups.push_back(classes.group(node.label));
  for (std::size_t q = 0; q < query.size(); ++q) {
    const auto& here = query.nodes()[q];
    if (!here.position) continue;
    const ClassId group = classes.group(here.label);
    for (std::size_t p = 0; p < candidate.size(); ++p) {
      const auto& there = candidate.nodes()[p];
      if (!there.position || candidate_groups[p] != group) continue;
      if (size_ratio(there, here) > max_size_ratio) continue;
      pairs.push_back({node_index(p), node_index(q)});
    }
  }
  return pairs;
}

/// Leaves the `count` pairs whose sizes differ least, ties by their order, which stays.
/// O(n log n).
template <typename Scalar>
void keep_most_alike(std::vector<Correspondence>& pairs, const TopologyGraph<Scalar>& candidate,
                     const TopologyGraph<Scalar>& query, std::size_t count) {
  std::vector<std::pair<double, Correspondence>> alike;
  alike.reserve(pairs.size());
  for (const Correspondence& pair : pairs) {
    alike.emplace_back(size_ratio(candidate.node(pair.candidate), query.node(pair.query)), pair);
  }
  const auto in_order = [](const auto& l, const auto& r) { return l.second < r.second; };
  std::stable_sort(alike.begin(), alike.end(),
                   [](const auto& l, const auto& r) { return l.first < r.first; });
  alike.resize(std::min(count, alike.size()));
  std::sort(alike.begin(), alike.end(), in_order);
  pairs.clear();
  for (const auto& [ratio, pair] : alike) pairs.push_back(pair);
}

}  // namespace detail
}  // namespace v0
}  // namespace topobag
