// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include <topobag/graph/gravity.hpp>
#include <topobag/graph/view.hpp>
#include <topobag/sensing/lift_detections.hpp>
#include <topobag/sensing/pinhole_camera.hpp>
#include <topobag/types/class_catalog.hpp>
#include <topobag/types/ranged_detection.hpp>
#include <topobag/types/semantic_node.hpp>

namespace topobag {
inline namespace v0 {

/// What one key frame shows: its nodes, and the view with all that may hide an object from it.
struct KeyframeSighting {
  double stamp = 0.0;                 ///< s
  std::vector<SemanticNode<>> nodes;  ///< in the key frame's camera frame
  View<> view;                        ///< its camera and what hides things from it
  /// Which way is down in its camera frame, where the front end knows.
  std::optional<Gravity<>> gravity = std::nullopt;
};

/// What of a key frame's detections is used.
struct SightingOptions {
  LiftOptions lifting{};             ///< which detections become nodes
  std::size_t max_detections = 256;  ///< the surest are used: a detector gone wild costs no more
};

/// Lifts the detections of a key frame and notes what they hide. People hide things too; a box of
/// half the image is a room and hides nothing. The gravity is the caller's to fill in.
///
/// @param stamp       s
/// @param detections  a vector of `RangedDetection`, as `range_detections` gives them
/// @param camera      of the image the boxes are in, with its size
/// Throws as `lift_detections`. O(n log n + duplicates).
template <typename Detections = std::vector<RangedDetection>>
KeyframeSighting sight_keyframe(double stamp, Detections detections, const PinholeCamera<>& camera,
                                const ClassCatalog& catalog, const SightingOptions& options = {}) {
  for (std::size_t i = 0; i < detections.size(); ++i) {  // by the caller's indices
    detail::require_known(catalog, detections[i].label, i);
  }
  if (detections.size() > options.max_detections) {
    std::stable_sort(detections.begin(), detections.end(), detail::IsSurer{});
    detections.resize(options.max_detections);
  }
  KeyframeSighting sighting;
  sighting.stamp = stamp;
  sighting.nodes = lift_detections(detections, camera, catalog, options.lifting).nodes;
  sighting.view.camera = camera;
  const double max_area = options.lifting.max_image_share * camera.width * camera.height;
  for (const RangedDetection& detection : detections) {
    if (detection.box.is_valid() && detection.confidence >= options.lifting.min_confidence &&
        detection.box.area() < max_area) {
      sighting.view.occluders.push_back({detection.box, detection.z});
    }
  }
  return sighting;
}

}  // namespace v0
}  // namespace topobag
