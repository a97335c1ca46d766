// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <map>
#include <vector>

#include <topobag/graph/topology_graph.hpp>
#include <topobag/matching/class_affinity.hpp>
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

/// Whether a node of the graph may be of several classes. O(n).
template <typename Scalar>
bool any_label_weights(const TopologyGraph<Scalar>& graph) {
  return std::any_of(graph.nodes().begin(), graph.nodes().end(),
                     [](const auto& node) { return !node.label_weights.empty(); });
}

/// The pairs of nodes with positions that may be one object: by `may_be_one`, and of about the same
/// size. Sorted by query node, then candidate node. O(n · k).
/// @param options  `ConsistencyOptions`
template <typename Scalar, typename Options>
std::vector<Correspondence> offered_pairs(const TopologyGraph<Scalar>& candidate,
                                          const TopologyGraph<Scalar>& query,
                                          const Options& options) {
  const ClassGroups& classes = options.classes;
  const bool by_group =
      !options.affinity && !any_label_weights(candidate) && !any_label_weights(query);
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
      if (!there.position || (by_group && candidate_groups[p] != group)) continue;
      if (size_ratio(there, here) > options.max_size_ratio) continue;
      if (!by_group && !may_be_one(there, here, classes, options.affinity, options.min_affinity)) {
        continue;
      }
      pairs.push_back({node_index(p), node_index(q)});
    }
  }
  return pairs;
}

/// Leaves `count` pairs: the classes with the fewest pairs whole as far as they fit, and of the
/// others the pairs whose sizes differ least. Their order stays; ties go by it. O(n log n).
template <typename Scalar>
void keep_telling(std::vector<Correspondence>& pairs, const TopologyGraph<Scalar>& candidate,
                  const TopologyGraph<Scalar>& query, std::size_t count) {
  std::map<ClassId, std::size_t> pairs_of_class;
  for (const Correspondence& pair : pairs) ++pairs_of_class[query.node(pair.query).label];
  std::vector<std::size_t> counts;
  for (const auto& [label, of_class] : pairs_of_class) counts.push_back(of_class);
  std::sort(counts.begin(), counts.end());
  std::size_t total = 0, largest_whole = 0;
  for (const std::size_t of_class : counts) {
    if ((total += of_class) > count) break;
    largest_whole = of_class;
  }
  struct Ranked {
    double rank;  // 0 for a class that stays whole, else the ratio of the sizes
    Correspondence pair;
  };
  std::vector<Ranked> ranked;
  ranked.reserve(pairs.size());
  for (const Correspondence& pair : pairs) {
    const bool whole = pairs_of_class[query.node(pair.query).label] <= largest_whole;
    ranked.push_back(
        {whole ? 0.0 : size_ratio(candidate.node(pair.candidate), query.node(pair.query)), pair});
  }
  std::stable_sort(ranked.begin(), ranked.end(),
                   [](const Ranked& l, const Ranked& r) { return l.rank < r.rank; });
  ranked.resize(std::min(count, ranked.size()));
  pairs.clear();
  for (const Ranked& kept : ranked) pairs.push_back(kept.pair);
  std::sort(pairs.begin(), pairs.end());
}

}  // namespace detail
}  // namespace v0
}  // namespace topobag
