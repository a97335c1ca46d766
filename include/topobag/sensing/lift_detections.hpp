// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <numeric>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

#include <topobag/sensing/depth_sampling.hpp>
#include <topobag/sensing/depth_view.hpp>
#include <topobag/sensing/node_noise.hpp>
#include <topobag/sensing/pinhole_camera.hpp>
#include <topobag/sensing/same_object.hpp>
#include <topobag/sensing/sensor_profile.hpp>
#include <topobag/types/class_catalog.hpp>
#include <topobag/types/detection.hpp>
#include <topobag/types/semantic_node.hpp>

namespace topobag {
inline namespace v0 {

/// Which detections become nodes.
struct LiftOptions {
  DynamicsSet keep{Dynamics::low,
                   Dynamics::medium};           ///< dynamic filter (3.1): levels that are kept
  double min_confidence = 0.3;                  ///< detector's score
  double min_depth = default_sensor.min_depth;  ///< m
  double max_depth = default_sensor.max_depth;  ///< m
  double max_image_share = 0.5;  ///< share of the image's area; such a box is a room, not an object
  SameObject duplicate{};        ///< of two nodes that are one object the surer one is kept
  NodeNoise noise{};             ///< gives each node its covariance
};

/// The same for a sensor.
inline LiftOptions lift_options(const SensorProfile& sensor) {
  LiftOptions options;
  options.min_depth = sensor.min_depth;
  options.max_depth = sensor.max_depth;
  options.noise = sensor.noise;
  return options;
}

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

/// eq. 1, 2, 5 for every detection; `depth_of(detection, box)` gives metres or nothing.
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
    } else if (const std::optional<double> z = depth_of(detection, box); !z || !std::isfinite(*z)) {
      ++lifted.dropped.no_depth;
    } else if (*z < options.min_depth || *z > options.max_depth) {
      ++lifted.dropped.out_of_range;
    } else {
      Node node;
      node.label = label;
      node.pixel = box.center().template cast<Scalar>();
      node.z = static_cast<Scalar>(*z);
      node.position = camera.back_project(*node.pixel, node.z);
      node.size = {static_cast<Scalar>(box.width()) * node.z / camera.fx,
                   static_cast<Scalar>(box.height()) * node.z / camera.fy};
      const bool truncated =
          size_known && (box.x1 < 2.0 || box.y1 < 2.0 || box.x2 > camera.width - 3.0 ||
                         box.y2 > camera.height - 3.0);
      node.covariance = options.noise
                            .covariance(node.position->template cast<double>(),
                                        node.size.template cast<double>(), truncated)
                            .template cast<Scalar>();
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

/// Turns a detector's boxes and a depth source into semantic nodes: eq. 1, 2 and 5.
///
/// @param detections  any range whose elements fit `detection_traits`; boxes are clipped to the
/// image
/// @param depth       depth source: `pixel -> optional metres`
/// @param camera      of the image the boxes are in; with its size known, cut and too large boxes
/// are seen
/// @param catalog     the classes that the labels number
/// @param sampling    depth sampling policy: `RobustBoxDepth`, or `CenterDepth` for the paper's
/// reading Throws UnknownClass with the detection's index, InvalidValue for a bad camera
/// and as `require_registered`. O(n · sampling).
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
        detections, [&](const T&, const BoundingBox& box) { return sampling(depth, box); }, camera,
        catalog, options);
  } else {
    return {};
  }
}

/// The same for detections that know their depth (`detection_traits<T>::depth`).
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
        [](const T& detection, const BoundingBox&) -> std::optional<double> {
          return detection_traits<T>::depth(detection);
        },
        camera, catalog, options);
  } else {
    return {};
  }
}

}  // namespace v0
}  // namespace topobag
