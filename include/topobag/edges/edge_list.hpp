// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <tuple>
#include <vector>

#include <topobag/types/ids.hpp>

namespace topobag {
inline namespace v0 {

/// An undirected edge between two nodes of one list, in canonical form: a < b.
struct Edge {
  NodeIndex a{};  ///< the smaller index
  NodeIndex b{};  ///< the larger index

  friend bool operator==(const Edge& l, const Edge& r) noexcept { return l.a == r.a && l.b == r.b; }
  friend bool operator!=(const Edge& l, const Edge& r) noexcept { return !(l == r); }
  friend bool operator<(const Edge& l, const Edge& r) noexcept {
    return std::tie(l.a, l.b) < std::tie(r.a, r.b);
  }
};

/// What an edge builder returns: edges in canonical form, sorted, each once.
using EdgeList = std::vector<Edge>;

/// The canonical edge between two different nodes.
inline Edge make_edge(NodeIndex i, NodeIndex j) noexcept { return i < j ? Edge{i, j} : Edge{j, i}; }

/// Sorts and removes repetitions. O(m log m).
inline void make_canonical(EdgeList& edges) {
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
}

}  // namespace v0
}  // namespace topobag
