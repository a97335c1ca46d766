// SPDX-License-Identifier: MIT
#include "table_stress.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace program {
namespace {

/// Numbers that the standard library's distributions would draw differently on each platform.
class Draws {
 public:
  explicit Draws(const TableStress& stress) {
    std::seed_seq seeds{stress.seed, stress.stream};
    engine_.seed(seeds);
  }

  /// In [0, 1), of 53 bits.
  double uniform() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }

  /// Standard normal (Box and Muller 1958).
  double normal() {
    const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform()));
    return radius * std::cos(6.283185307179586 * uniform());
  }

 private:
  std::mt19937_64 engine_;
};

std::vector<topobag::ClassId> classes_of(const NodeTable& table) {
  std::set<topobag::ClassId> classes;
  for (const FrameRow& frame : table.frames) {
    for (const topobag::RangedDetection& detection : frame.detections) classes.insert(detection.label);
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
  Draws draws(stress);
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
