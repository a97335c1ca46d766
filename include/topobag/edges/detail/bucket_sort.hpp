// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <topobag/edges/edge_list.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// The edges of a graph over `num_nodes` nodes, each in canonical form and given once, in canonical
/// order. O(n + m log d) with d the largest degree: faster than a sort where degrees are small.
inline EdgeList bucket_sort(const EdgeList& edges, std::size_t num_nodes) {
  std::vector<std::uint32_t> end(num_nodes + 1, 0);  // of the bucket of each a, once filled
  for (const Edge& edge : edges) ++end[value(edge.a) + 1];
  for (std::size_t a = 1; a <= num_nodes; ++a) end[a] += end[a - 1];

  EdgeList sorted(edges.size());
  for (const Edge& edge : edges) sorted[end[value(edge.a)]++] = edge;

  std::size_t begin = 0;
  for (std::size_t a = 0; a < num_nodes; begin = end[a++]) {
    std::sort(sorted.begin() + static_cast<std::ptrdiff_t>(begin),
              sorted.begin() + static_cast<std::ptrdiff_t>(end[a]),
              [](const Edge& l, const Edge& r) { return l.b < r.b; });
  }
  return sorted;
}

}  // namespace detail
}  // namespace v0
}  // namespace topobag
