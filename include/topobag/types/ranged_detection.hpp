// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include <topobag/types/appearance.hpp>
#include <topobag/types/bounding_box.hpp>
#include <topobag/types/detection.hpp>
#include <topobag/types/ids.hpp>

namespace topobag {
inline namespace v0 {

/// A detection that knows its depth, and may say how well, what its object looks like and what else
/// it may be.
struct RangedDetection {
  BoundingBox box;               ///< px
  ClassId label{};               ///< class, numbered as in the catalog in use
  double confidence = 1.0;       ///< detector's score in [0, 1]
  double z = 0.0;                ///< depth, m; 0 = unknown
  Appearance appearance{};       ///< of its object; unknown by default
  LabelWeights label_weights{};  ///< what it may be; none by default
  double z_deviation = 0.0;      ///< σ of the depth beside the sensor's noise, m; 0 = none
};

/// The library's own detection with a depth, an appearance and label weights.
template <>
struct detection_traits<RangedDetection> {
  static const BoundingBox& box(const RangedDetection& d) { return d.box; }
  static ClassId label(const RangedDetection& d) { return d.label; }
  static double confidence(const RangedDetection& d) { return d.confidence; }
  static std::optional<double> depth(const RangedDetection& d) {
    return d.z > 0.0 ? std::optional<double>(d.z) : std::nullopt;
  }
  /// How far off the depth may be beside the sensor's noise.
  static double depth_deviation(const RangedDetection& d) { return d.z_deviation; }
  /// What the object looks like, where that is known.
  static const Appearance& appearance(const RangedDetection& d) { return d.appearance; }
  /// What the object may be, where that is known.
  static const LabelWeights& label_weights(const RangedDetection& d) { return d.label_weights; }
};

}  // namespace v0
}  // namespace topobag
