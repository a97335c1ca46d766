// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

#include <topobag/error.hpp>
#include <topobag/matching/layout_prior.hpp>
#include <topobag/types/ids.hpp>

namespace topobag {
inline namespace v0 {

/// Learns at which distances the objects of two classes stand: every place has one vote a pair of
/// classes, shared among its pairs. Places whose graphs know no gravity tell distances in space
/// alone.
/// @param places  one graph a place, with each object of it once
/// @param prior   what was learnt before
/// Throws InvalidValue where nothing is given. O(places · objects²).
template <typename Graph>
LayoutPrior learn_layouts(const std::vector<Graph>& places, LayoutPrior prior = {}) {
  if (places.empty()) throw InvalidValue("layouts are learnt from one place or more");
  for (const Graph& place : places) {
    std::map<std::pair<ClassId, ClassId>, std::array<DistanceCounts, 2>> here;
    const auto& gravity = place.gravity();
    const auto& nodes = place.nodes();
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        if (!nodes[i].position || !nodes[j].position) continue;
        const Eigen::Vector3d between =
            (*nodes[i].position - *nodes[j].position).template cast<double>();
        if (between.norm() > DistanceBins::most) continue;
        auto& counts = here[std::minmax(nodes[i].label, nodes[j].label)];
        counts[1][DistanceBins::of(between.norm())] += 1.0;
        if (!gravity) continue;
        const Eigen::Vector3d down = gravity->down.template cast<double>();
        counts[0][DistanceBins::of((between - down * down.dot(between)).norm())] += 1.0;
      }
    }
    for (auto& [classes, counts] : here) {
      for (DistanceCounts& kind : counts) {
        double pairs = 0.0;
        for (const double count : kind) pairs += count;
        for (double& count : kind) count /= std::max(1.0, pairs);
      }
      prior.add(classes.first, classes.second, counts[0], counts[1]);
    }
  }
  return prior;
}

}  // namespace v0
}  // namespace topobag
