// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <topobag/edges/edge_list.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// Copies the edges ordered by one of their ends; equal ones keep their order.
/// `places` is scratch space.
template <NodeIndex Edge::*End>
void bucket_pass(const EdgeList& edges, std::size_t num_nodes, std::vector<std::uint32_t>& places,
                 EdgeList& sorted) {
  places.assign(num_nodes + 1, 0);
  for (const Edge& edge : edges) ++places[value(edge.*End) + 1];
  for (std::size_t i = 1; i <= num_nodes; ++i) places[i] += places[i - 1];
  for (const Edge& edge : edges) sorted[places[value(edge.*End)]++] = edge;
}

/// Puts the edges of a graph over `num_nodes` nodes, each given once with a < b, in canonical
/// order. O(n + m), and free of the branches on random data that a comparison sort stumbles over.
inline void bucket_sort(EdgeList& edges, std::size_t num_nodes) {
  std::vector<std::uint32_t> places;
  EdgeList by_b(edges.size());
  bucket_pass<&Edge::b>(edges, num_nodes, places, by_b);
  bucket_pass<&Edge::a>(by_b, num_nodes, places, edges);
}

}  // namespace detail
}  // namespace v0
}  // namespace topobag
