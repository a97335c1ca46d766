// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <optional>
#include <type_traits>
#include <vector>

#include <Eigen/Core>

#include <topobag/error.hpp>
#include <topobag/sensing/depth_view.hpp>
#include <topobag/types/class_catalog.hpp>
#include <topobag/types/detection.hpp>
#include <topobag/types/ranged_detection.hpp>

namespace topobag {
inline namespace v0 {

/// Which boxes mask features, and how much of what is in them.
struct DynamicFeatureOptions {
  DynamicsSet levels{Dynamics::high};  ///< whose features are not to be trusted
  double min_confidence = 0.3;         ///< detector's score below which a box masks nothing
  double reach = 0.5;   ///< m before and behind the box's depth that belong to the object
  double margin = 3.0;  ///< px by which boxes are widened

  /// The paper's own sentence (3.1): features "in the highly dynamic region and low dynamic region"
  /// are outliers, wherever in the box they lie. It masks desks and monitors too, of which the
  /// paper says elsewhere that they are static.
  static DynamicFeatureOptions paper() {
    return {{Dynamics::high, Dynamics::low}, 0.3, std::numeric_limits<double>::infinity(), 0.0};
  }
};

/// Tells which image features lie on things that move: the paper's 3.1.
///
/// A box holds background as well; where depth tells it apart, it is kept. A feature is masked when
/// it lies in a dynamic box and its depth is within `reach` of the box's, or either depth is
/// unknown.
class DynamicFeatureMask {
 public:
  /// @param detections  of the image: any range whose elements fit `detection_traits`; where these
  ///                    know a depth, the background within a box is told apart
  /// @param catalog     says how readily each class moves
  /// Boxes that are not valid and scores that are not finite mask nothing. Throws UnknownClass with
  /// the detection's index, InvalidValue for a reach or margin below 0 or NaN.
  template <typename Detections = std::vector<RangedDetection>>
  DynamicFeatureMask(const Detections& detections, const ClassCatalog& catalog,
                     const DynamicFeatureOptions& options = {})
      : reach_(options.reach) {
    using T = std::decay_t<decltype(*std::begin(detections))>;
    using Traits = detection_traits<T>;
    static_assert(require_detection<T>());
    if (!(options.reach >= 0.0) || !(options.margin >= 0.0)) {
      throw InvalidValue("a feature mask's reach and margin must not be below 0");
    }
    std::size_t index = 0;
    for (const T& detection : detections) {
      const ClassId label = Traits::label(detection);
      detail::require_known(catalog, label, index++);
      Region region{Traits::box(detection), depth_of(detection).value_or(0.0)};
      if (!region.box.is_valid()) continue;
      if (!(Traits::confidence(detection) >= options.min_confidence)) continue;
      if (!options.levels.contains(catalog.dynamics(label))) continue;
      region.box.x1 -= options.margin;
      region.box.y1 -= options.margin;
      region.box.x2 += options.margin;
      region.box.y2 += options.margin;
      regions_.push_back(region);
    }
  }

  /// Whether anything in the image is masked at all.
  bool empty() const noexcept { return regions_.empty(); }

  /// Whether the feature at `pixel` is to be dropped.
  /// @param z  its depth, m; absent, 0 or not finite = unknown
  /// O(dynamic boxes).
  bool operator()(const Eigen::Vector2d& pixel, std::optional<double> z) const noexcept {
    const bool known = z && std::isfinite(*z) && *z > 0.0;
    for (const Region& region : regions_) {
      if (!region.box.contains(pixel)) continue;
      if (!known || !(region.z > 0.0) || std::abs(*z - region.z) <= reach_) return true;
    }
    return false;
  }

  /// The same for many features, with their depth from a depth source: `true` = to be dropped.
  template <typename Depth>
  std::vector<bool> masked(const std::vector<Eigen::Vector2d>& pixels, const Depth& depth) const {
    static_assert(is_depth_source_v<Depth>,
                  "topobag: a depth source is callable as depth(Eigen::Vector2d pixel) -> "
                  "std::optional<double> metres.");
    std::vector<bool> drop(pixels.size());
    for (std::size_t i = 0; i < pixels.size(); ++i) drop[i] = (*this)(pixels[i], depth(pixels[i]));
    return drop;
  }

 private:
  struct Region {
    BoundingBox box;  ///< px
    double z;         ///< m; 0 = unknown
  };

  double reach_;
  std::vector<Region> regions_;
};

}  // namespace v0
}  // namespace topobag
