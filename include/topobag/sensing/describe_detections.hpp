// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <topobag/sensing/color_descriptor.hpp>
#include <topobag/sensing/depth_view.hpp>
#include <topobag/sensing/image_view.hpp>
#include <topobag/types/ranged_detection.hpp>

namespace topobag {
inline namespace v0 {

/// Gives every detection the colours of its object.
/// @param image  that the boxes are in
/// @param depth  depth source of that image; pixels before and behind the object are left out where
///               both depths are known
/// Throws as `require_registered`. O(pixels / 64 + n · grid²).
template <typename Depth>
void describe_detections(std::vector<RangedDetection>& detections, const ImageView& image,
                         const Depth& depth, const ColorDescriptorOptions& options = {}) {
  require_registered(depth, image.width(), image.height());
  const ColorDescriptor describe(image, options);
  for (RangedDetection& detection : detections) {
    detection.appearance = describe(detection.box, depth, detection.z);
  }
}

}  // namespace v0
}  // namespace topobag
