// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <iterator>
#include <optional>
#include <type_traits>
#include <utility>

#include <topobag/sensing/depth_estimate.hpp>
#include <topobag/sensing/depth_sampling.hpp>
#include <topobag/sensing/depth_view.hpp>
#include <topobag/sensing/lift_options.hpp>
#include <topobag/sensing/lifted_nodes.hpp>
#include <topobag/sensing/node_noise.hpp>
#include <topobag/sensing/pinhole_camera.hpp>
#include <topobag/types/class_catalog.hpp>
#include <topobag/types/detection.hpp>
#include <topobag/types/semantic_node.hpp>

namespace topobag {
inline namespace v0 {

namespace detail {

/// Notes what else a node may be. Throws UnknownClass for a class that the catalog does not hold,
/// InvalidValue where another one than the node's is the best, both with the detection's index.
template <typename Scalar>
void set_label_weights(SemanticNode<Scalar>& node, const LabelWeights& weights,
                       const ClassCatalog& catalog, std::size_t index) {
  for (std::size_t i = 0; i < weights.size(); ++i) require_known(catalog, weights.label(i), index);
  if (!has_best_label(node.label, weights)) {
    throw InvalidValue(
        "detection " + std::to_string(index) + " has label weights whose best is not its label",
        index);
  }
  node.label_weights = weights;
}

/// Adds what is not known of the depth to a node's covariance: it moves the node along its ray.
template <typename Scalar>
void add_depth_deviation(SemanticNode<Scalar>& node, double deviation) {
  if (!(deviation > 0.0)) return;
  const Eigen::Vector3d along =
      deviation / static_cast<double>(node.z) * node.position->template cast<double>();
  node.covariance += Eigen::Matrix3d(along * along.transpose()).template cast<Scalar>();
}

/// eq. 1, 2, 5 for every detection; `depth_of(detection, box)` gives a `DepthEstimate` or nothing.
template <typename Detections, typename DepthOf, typename Scalar>
LiftedNodes<Scalar> lift_with(const Detections& detections, const DepthOf& depth_of,
                              const PinholeCamera<Scalar>& camera, const ClassCatalog& catalog,
                              const LiftOptions& options) {
  using Traits = detection_traits<std::decay_t<decltype(*std::begin(detections))>>;
  using Node = SemanticNode<Scalar>;
  camera.validate();
  const bool size_known = camera.width > 0 && camera.height > 0;
  LiftedNodes<Scalar> lifted;
  std::size_t index = 0;
  for (auto it = std::begin(detections); it != std::end(detections); ++it, ++index) {
    const auto& detection = *it;
    const BoundingBox given = Traits::box(detection);
    const BoundingBox box =
        given.is_valid() && size_known ? given.clipped(camera.width, camera.height) : given;
    const double confidence = Traits::confidence(detection);
    const ClassId label = Traits::label(detection);
    detail::require_known(catalog, label, index);
    if (!box.is_valid() || !std::isfinite(confidence)) {
      ++lifted.dropped.invalid;
    } else if (confidence < options.min_confidence) {
      ++lifted.dropped.low_confidence;
    } else if (!options.keep.contains(catalog.dynamics(label))) {
      ++lifted.dropped.dynamic;
    } else if (size_known && box.area() > options.max_image_share * camera.width * camera.height) {
      ++lifted.dropped.too_large;
    } else if (const std::optional<DepthEstimate> depth = depth_of(detection, box);
               !depth || !std::isfinite(depth->z)) {
      ++lifted.dropped.no_depth;
    } else if (depth->z < options.min_depth || depth->z > options.max_depth) {
      ++lifted.dropped.out_of_range;
    } else {
      Node node;
      node.label = label;
      node.pixel = box.center().template cast<Scalar>();
      node.z = static_cast<Scalar>(depth->z);
      node.position = camera.back_project(*node.pixel, node.z);
      node.size = {static_cast<Scalar>(box.width()) * node.z / camera.fx,
                   static_cast<Scalar>(box.height()) * node.z / camera.fy};
      const bool truncated = size_known && box.is_cut(camera.width, camera.height);
      node.covariance = options.noise
                            .covariance(node.position->template cast<double>(),
                                        node.size.template cast<double>(), truncated)
                            .template cast<Scalar>();
      add_depth_deviation(node, depth->deviation);
      if (!node.position->allFinite() || !node.covariance.allFinite()) {
        ++lifted.dropped.invalid;
        continue;
      }
      node.confidence = static_cast<Scalar>(confidence);
      node.appearance = appearance_of(detection);
      set_label_weights(node, label_weights_of(detection), catalog, index);
      lifted.nodes.push_back(std::move(node));
      lifted.sources.push_back(index);
    }
  }
  drop_duplicates(lifted, options.duplicate);
  return lifted;
}

}  // namespace detail

/// Turns a detector's boxes and a depth source into semantic nodes: eq. 1, 2 and 5. A node's
/// covariance is the noise of the options and, beside it, the deviation of its depth where the
/// sampling or the detection tells one (`DepthEstimate`).
///
/// Throws UnknownClass with the detection's index, InvalidValue for a bad camera and as
/// `require_registered`. O(n · sampling).
///
/// @param detections  any range whose elements fit `detection_traits`; boxes are clipped to the
///                    image
/// @param depth       depth source: `pixel -> optional metres`
/// @param camera      of the image the boxes are in; with its size known, cut and too large boxes
///                    are seen
/// @param catalog     the classes that the labels number
/// @param sampling    `RobustBoxDepth`, or `CenterDepth` for the paper's reading
template <typename Detections, typename Depth, typename Scalar, typename Sampling = RobustBoxDepth>
LiftedNodes<Scalar> lift_detections(const Detections& detections, const Depth& depth,
                                    const PinholeCamera<Scalar>& camera,
                                    const ClassCatalog& catalog, const LiftOptions& options = {},
                                    const Sampling& sampling = {}) {
  using T = std::decay_t<decltype(*std::begin(detections))>;
  static_assert(require_detection<T>());
  static_assert(is_depth_source_v<Depth>,
                "topobag: a depth source is callable as depth(Eigen::Vector2d pixel) -> "
                "std::optional<double> metres.");
  static_assert(is_depth_sampling_v<Sampling, Depth>,
                "topobag: a depth sampling policy is callable as sampling(depth source, "
                "BoundingBox) -> std::optional<double> metres.");
  if constexpr (is_detection_v<T> && is_depth_source_v<Depth> &&
                is_depth_sampling_v<Sampling, Depth>) {
    require_registered(depth, camera.width, camera.height);
    return detail::lift_with(
        detections,
        [&](const T&, const BoundingBox& box) { return sampled_depth(sampling, depth, box); },
        camera, catalog, options);
  } else {
    return {};
  }
}

/// The same for detections that know their depth (`detection_traits<T>::depth`, and
/// `depth_deviation`).
template <typename Detections, typename Scalar>
LiftedNodes<Scalar> lift_detections(const Detections& detections,
                                    const PinholeCamera<Scalar>& camera,
                                    const ClassCatalog& catalog, const LiftOptions& options = {}) {
  using T = std::decay_t<decltype(*std::begin(detections))>;
  static_assert(require_detection<T>());
  static_assert(is_ranged_detection_v<T>,
                "topobag: without a depth source, topobag::detection_traits needs "
                "depth(const T&) -> std::optional<double> metres.");
  if constexpr (is_ranged_detection_v<T>) {
    return detail::lift_with(
        detections,
        [](const T& detection, const BoundingBox&) -> std::optional<DepthEstimate> {
          const std::optional<double> z = detection_traits<T>::depth(detection);
          if (!z) return std::nullopt;
          return DepthEstimate{*z, depth_deviation_of(detection)};
        },
        camera, catalog, options);
  } else {
    return {};
  }
}

}  // namespace v0
}  // namespace topobag
