// SPDX-License-Identifier: MIT
#include "table_stress.hpp"

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "draws.hpp"

namespace program {
namespace {

std::vector<topobag::ClassId> classes_of(const NodeTable& table) {
  std::set<topobag::ClassId> classes;
  for (const FrameRow& frame : table.frames) {
    for (const auto& detection : frame.detections) classes.insert(detection.label);
  }
  return {classes.begin(), classes.end()};
}

/// The class at `share` in [0, 1) of the ascending other classes; `label` when there is no other.
topobag::ClassId other_class(const std::vector<topobag::ClassId>& classes, topobag::ClassId label,
                             double share) {
  const std::size_t others = classes.size() - 1;
  if (others == 0) return label;
  const auto i = static_cast<std::size_t>(share * static_cast<double>(others));
  return classes[i] < label ? classes[i] : classes[i + 1];
}

}  // namespace

void apply(const TableStress& stress, NodeTable& table) {
  if (!stress.any()) return;
  Draws draws{stress.seed, stress.stream};
  const std::vector<topobag::ClassId> classes = classes_of(table);
  for (FrameRow& frame : table.frames) {
    std::vector<topobag::RangedDetection> kept;
    for (topobag::RangedDetection detection : frame.detections) {
      const bool dropped = draws.uniform() < stress.drop;
      const bool flipped = draws.uniform() < stress.flip;
      const double share = draws.uniform();
      const double noise = draws.normal();
      if (dropped) continue;
      if (flipped) detection.label = other_class(classes, detection.label, share);
      detection.z = std::max(0.0, detection.z * (1.0 + stress.depth_noise * noise));
      kept.push_back(detection);
    }
    frame.detections = std::move(kept);
  }
}

}  // namespace program
