// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <iterator>
#include <optional>
#include <type_traits>
#include <vector>

#include <topobag/sensing/depth_estimate.hpp>
#include <topobag/sensing/depth_sampling.hpp>
#include <topobag/sensing/depth_view.hpp>
#include <topobag/sensing/pinhole_camera.hpp>
#include <topobag/types/ranged_detection.hpp>

namespace topobag {
inline namespace v0 {

/// Gives every detection its depth, with its deviation where the sampling tells one, and keeps its
/// appearance and label weights, so that lifting, occlusion and the feature mask sample it once.
///
/// @param detections  any range whose elements fit `detection_traits`
/// @param depth       depth source: `pixel -> optional metres`
/// @param camera      boxes are clipped to its image where its size is known
/// @param sampling    depth sampling policy
/// One result for each detection, in order; z = 0 where there is no depth, as for a box that is not
/// valid. Throws as `require_registered`. O(n · sampling).
template <typename Detections, typename Depth, typename Scalar, typename Sampling = RobustBoxDepth>
std::vector<RangedDetection> range_detections(const Detections& detections, const Depth& depth,
                                              const PinholeCamera<Scalar>& camera,
                                              const Sampling& sampling = {}) {
  using T = std::decay_t<decltype(*std::begin(detections))>;
  using Traits = detection_traits<T>;
  static_assert(require_detection<T>());
  static_assert(is_depth_source_v<Depth>,
                "topobag: a depth source is callable as depth(Eigen::Vector2d pixel) -> "
                "std::optional<double> metres.");
  static_assert(is_depth_sampling_v<Sampling, Depth>,
                "topobag: a depth sampling policy is callable as sampling(depth source, "
                "BoundingBox) -> std::optional<double> metres.");
  require_registered(depth, camera.width, camera.height);
  const bool size_known = camera.width > 0 && camera.height > 0;
  std::vector<RangedDetection> ranged;
  for (const auto& detection : detections) {
    BoundingBox box = Traits::box(detection);
    if (box.is_valid() && size_known) box = box.clipped(camera.width, camera.height);
    std::optional<DepthEstimate> found;
    if (box.is_valid()) found = sampled_depth(sampling, depth, box);
    if (!found || !std::isfinite(found->z) || !(found->z > 0.0)) found = DepthEstimate{};
    ranged.push_back({box, Traits::label(detection), Traits::confidence(detection), found->z,
                      appearance_of(detection), label_weights_of(detection), found->deviation});
  }
  return ranged;
}

}  // namespace v0
}  // namespace topobag
