// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include <topobag/graph/keyframe_sighting.hpp>
#include <topobag/sensing/depth_grid.hpp>
#include <topobag/sensing/depth_sampling.hpp>
#include <topobag/sensing/depth_view.hpp>
#include <topobag/sensing/lift_detections.hpp>
#include <topobag/sensing/pinhole_camera.hpp>
#include <topobag/sensing/range_detections.hpp>
#include <topobag/types/class_catalog.hpp>
#include <topobag/types/detection.hpp>
#include <topobag/types/ranged_detection.hpp>

namespace topobag {
inline namespace v0 {

/// What of a key frame's detections is used.
struct SightingOptions {
  LiftOptions lifting{};             ///< which detections become nodes
  std::size_t max_detections = 256;  ///< the surest are used: a detector gone wild costs no more
};

/// Lifts the detections of a key frame and notes what they hide. People hide things too; a box of
/// half the image is a room and hides nothing. The gravity is the caller's to fill in.
///
/// @param stamp       s
/// @param detections  a vector whose elements fit `detection_traits`, with a depth
/// @param camera      of the image the boxes are in, with its size
/// Throws as `lift_detections`. O(n log n + duplicates).
template <typename Detections = std::vector<RangedDetection>>
KeyframeSighting sight_keyframe(double stamp, Detections detections, const PinholeCamera<>& camera,
                                const ClassCatalog& catalog, const SightingOptions& options = {}) {
  using T = typename Detections::value_type;
  using Traits = detection_traits<T>;
  static_assert(is_ranged_detection_v<T>,
                "topobag: without a depth source, topobag::detection_traits needs "
                "depth(const T&) -> std::optional<double> metres.");
  for (std::size_t i = 0; i < detections.size(); ++i) {  // by the caller's indices
    detail::require_known(catalog, Traits::label(detections[i]), i);
  }
  if (detections.size() > options.max_detections) {
    std::stable_sort(detections.begin(), detections.end(), detail::IsSurer{});
    detections.erase(detections.begin() + static_cast<std::ptrdiff_t>(options.max_detections),
                     detections.end());
  }
  KeyframeSighting sighting;
  sighting.stamp = stamp;
  sighting.nodes = lift_detections(detections, camera, catalog, options.lifting).nodes;
  sighting.view.camera = camera;
  const double max_area = options.lifting.max_image_share * camera.width * camera.height;
  for (const T& detection : detections) {
    const BoundingBox box = Traits::box(detection);
    if (box.is_valid() && Traits::confidence(detection) >= options.lifting.min_confidence &&
        box.area() < max_area) {
      sighting.view.occluders.push_back({box, depth_of(detection).value_or(0.0)});
    }
  }
  return sighting;
}

/// The same with the depth image at hand: it gives each detection its depth, and the view how far it
/// sees (`View::depth`), so that what was moved away can be told from what is hidden.
///
/// @param detections  any range whose elements fit `detection_traits`
/// @param depth       depth source of the image: `pixel -> optional metres`
/// @param sampling    depth sampling policy
/// Throws as `range_detections` too. O(n log n + duplicates + n · sampling).
template <typename Detections, typename Depth, typename Sampling = RobustBoxDepth>
KeyframeSighting sight_keyframe(double stamp, const Detections& detections, const Depth& depth,
                                const PinholeCamera<>& camera, const ClassCatalog& catalog,
                                const SightingOptions& options = {}, const Sampling& sampling = {}) {
  KeyframeSighting sighting = sight_keyframe(
      stamp, range_detections(detections, depth, camera, sampling), camera, catalog, options);
  if (camera.width > 0 && camera.height > 0) {
    sighting.view.depth.emplace(depth, camera.width, camera.height);
  }
  return sighting;
}

}  // namespace v0
}  // namespace topobag
