// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include <topobag/bag/entry_info.hpp>
#include <topobag/graph/topology_graph.hpp>

/// A user's bag that takes what ours refuse: key frame 12, of 5000 nodes.
struct CarelessBag {
  using Graph = topobag::TopologyGraph<>;
  std::size_t size() const { return 1; }
  template <typename F>
  void for_each(const F& f) const {
    f(topobag::KeyframeId{12}, topobag::EntryInfo{},
      Graph(std::vector<topobag::SemanticNode<>>(5000)));
  }
};
