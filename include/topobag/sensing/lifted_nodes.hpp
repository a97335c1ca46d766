// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

#include <topobag/sensing/same_object.hpp>
#include <topobag/types/semantic_node.hpp>

namespace topobag {
inline namespace v0 {

/// Why detections did not become nodes, counted. The first reason that applies counts, in this
/// order.
struct DroppedDetections {
  std::size_t invalid = 0;  ///< box or score not finite, empty, outside the image or of a size
                            ///< that overflows
  std::size_t low_confidence = 0;  ///< score below `min_confidence`
  std::size_t dynamic = 0;         ///< class of a level that is not kept
  std::size_t too_large = 0;       ///< box beyond `max_image_share`
  std::size_t no_depth = 0;        ///< nothing measured
  std::size_t out_of_range = 0;    ///< depth outside `min_depth` to `max_depth`
  std::size_t duplicate = 0;       ///< a surer detection gives the same object

  /// All of them.
  std::size_t total() const noexcept {
    return invalid + low_confidence + dynamic + too_large + no_depth + out_of_range + duplicate;
  }

  /// Adds the counts of another frame.
  DroppedDetections& operator+=(const DroppedDetections& other) noexcept {
    invalid += other.invalid;
    low_confidence += other.low_confidence;
    dynamic += other.dynamic;
    too_large += other.too_large;
    no_depth += other.no_depth;
    out_of_range += other.out_of_range;
    duplicate += other.duplicate;
    return *this;
  }
};

/// The nodes of one frame, in detection order.
template <typename Scalar>
struct LiftedNodes {
  std::vector<SemanticNode<Scalar>> nodes;  ///< in detection order
  std::vector<std::size_t> sources;         ///< index of the detection behind each node
  DroppedDetections dropped;                ///< what did not become a node
};

namespace detail {

/// Keeps the surest of the nodes that are one object. O(n · kept).
template <typename Scalar>
void drop_duplicates(LiftedNodes<Scalar>& lifted, const SameObject& same_object) {
  std::vector<std::size_t> by_confidence(lifted.nodes.size());
  std::iota(by_confidence.begin(), by_confidence.end(), std::size_t{0});
  std::stable_sort(by_confidence.begin(), by_confidence.end(), [&](std::size_t a, std::size_t b) {
    return lifted.nodes[a].confidence > lifted.nodes[b].confidence;
  });
  std::vector<std::size_t> kept;
  for (const std::size_t i : by_confidence) {
    const bool twin = std::any_of(kept.begin(), kept.end(), [&](std::size_t k) {
      return same_object(lifted.nodes[k], lifted.nodes[i]);
    });
    if (!twin) kept.push_back(i);
  }
  lifted.dropped.duplicate = lifted.nodes.size() - kept.size();
  if (lifted.dropped.duplicate == 0) return;
  std::sort(kept.begin(), kept.end());
  LiftedNodes<Scalar> unique;
  unique.dropped = lifted.dropped;
  for (const std::size_t i : kept) {
    unique.nodes.push_back(lifted.nodes[i]);
    unique.sources.push_back(lifted.sources[i]);
  }
  lifted = std::move(unique);
}

}  // namespace detail
}  // namespace v0
}  // namespace topobag
