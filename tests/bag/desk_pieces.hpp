// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <random>
#include <vector>

#include "random_graphs.hpp"

/// Graphs like those of the sample tables: 3 to 10 objects, 5 on average, of ten classes of which
/// three make up more than half; all with a size, nine in ten with a position.
inline std::vector<topobag::TopologyGraph<>> desk_pieces(unsigned seed, std::size_t count = 100) {
  std::mt19937 random(seed);
  std::geometric_distribution<int> more(0.33), label(0.25);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  std::vector<topobag::TopologyGraph<>> pieces;
  for (std::size_t i = 0; i < count; ++i) {
    auto nodes = random_nodes(random, static_cast<std::size_t>(3 + std::min(more(random), 7)));
    for (auto& node : nodes) {
      node.label = topobag::ClassId{std::min(label(random), 9)};
      node.size *= 0.4;
      node.position->y() *= 0.3;
      if (unit(random) < 0.1) node.position.reset();
    }
    pieces.push_back(topobag::make_topology_graph(std::move(nodes), topobag::KnnEdges{}));
  }
  return pieces;
}
