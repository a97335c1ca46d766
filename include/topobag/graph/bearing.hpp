// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <iterator>
#include <optional>
#include <type_traits>
#include <vector>

#include <Eigen/Core>

#include <topobag/graph/gravity.hpp>
#include <topobag/graph/view.hpp>
#include <topobag/sensing/lift_detections.hpp>
#include <topobag/sensing/pinhole_camera.hpp>
#include <topobag/types/appearance.hpp>
#include <topobag/types/class_catalog.hpp>
#include <topobag/types/detection.hpp>
#include <topobag/types/ids.hpp>

namespace topobag {
inline namespace v0 {

/// One object of which only the direction is known: what a lost camera without depth sees.
struct Bearing {
  ClassId label{};                                       ///< class
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();  ///< unit vector in the camera's frame
  double deviation = 0.02;                               ///< rad; σ about each axis across it
  Eigen::Vector2d extent = Eigen::Vector2d::Zero();      ///< width and height over the depth:
                                                         ///< the box in focal lengths; 0 = unknown
  double confidence = 1.0;                               ///< detector's score in [0, 1]
  Appearance appearance{};                               ///< what it looks like
};

/// What one image without depth shows.
struct BearingSighting {
  std::vector<Bearing> bearings;     ///< in detection order
  std::vector<std::size_t> sources;  ///< index of the detection behind each bearing
  View<> view;                       ///< the camera, and every box; how far away is unknown
  std::optional<Gravity<>> gravity;  ///< which way is down in the camera's frame; the caller's
  DroppedDetections dropped;         ///< what did not become a bearing
};

/// How far a box's middle lies from where its object's centre is seen, as one standard deviation.
/// Smaller than what `NodeNoise` says of a position, of which most is the object's own depth.
struct BearingNoise {
  double floor = 0.004;      ///< rad; a few pixels
  double jitter = 0.04;      ///< share of the box's extent
  double truncation = 0.15;  ///< share of the extent, more, of a box that the image's border cuts

  /// rad
  double deviation(double extent, bool truncated) const {
    return std::hypot(floor, std::hypot(jitter * extent, truncated ? truncation * extent : 0.0));
  }
};

/// Which detections become bearings.
struct BearingLiftOptions {
  LiftOptions lifting{};  ///< as for nodes with depth, but for all that it says of depths
  BearingNoise noise{};   ///< gives each bearing its deviation
};

/// Turns the detections of an image into directions. Which of them are used, `options` say as for
/// `lift_detections`, but for their depths, which nobody knows: of two boxes that would be one
/// object were they equally far the surer one is kept. Of a box that the image's border cuts the
/// extent is unknown.
///
/// @param detections  any range whose elements fit `detection_traits`
/// @param camera      of the image the boxes are in, with its size
/// Throws as `lift_detections`. O(n · kept).
template <typename Detections>
BearingSighting sight_bearings(const Detections& detections, const PinholeCamera<>& camera,
                               const ClassCatalog& catalog,
                               const BearingLiftOptions& options = {}) {
  using Detected = std::decay_t<decltype(*std::begin(detections))>;
  static_assert(require_detection<Detected>());
  using Traits = detection_traits<Detected>;
  LiftOptions at_one_metre = options.lifting;
  at_one_metre.min_depth = at_one_metre.max_depth = 1.0;
  const auto one_metre = [](const auto&, const BoundingBox&) {
    return std::optional(DepthEstimate{1.0, 0.0});
  };
  const auto lifted = detail::lift_with(detections, one_metre, camera, catalog, at_one_metre);
  BearingSighting sighting;
  sighting.dropped = lifted.dropped;
  sighting.sources = lifted.sources;
  sighting.view.camera = camera;
  for (const SemanticNode<>& node : lifted.nodes) {
    Bearing bearing;
    bearing.label = node.label;
    bearing.direction = node.position->normalized();
    const Eigen::Vector2d half(0.5 * node.size.x() * camera.fx, 0.5 * node.size.y() * camera.fy);
    const double border = 2.0;  // px
    const bool whole = camera.width <= 0 || camera.height <= 0 ||
                       (camera.in_image(*node.pixel - half, border) &&
                        camera.in_image(*node.pixel + half, border));
    if (whole) bearing.extent = node.size;
    bearing.deviation = options.noise.deviation(std::sqrt(node.size.x() * node.size.y()), !whole);
    bearing.confidence = node.confidence;
    bearing.appearance = node.appearance;
    sighting.bearings.push_back(bearing);
  }
  const double max_area = options.lifting.max_image_share * camera.width * camera.height;
  for (const Detected& detection : detections) {
    const BoundingBox box = Traits::box(detection);
    if (box.is_valid() && Traits::confidence(detection) >= options.lifting.min_confidence &&
        box.area() < max_area) {
      sighting.view.occluders.push_back({box, 0.0});
    }
  }
  return sighting;
}

}  // namespace v0
}  // namespace topobag
