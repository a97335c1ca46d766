// SPDX-License-Identifier: MIT
#include "typical_sizes.hpp"

#include <cmath>

namespace program {

void disbelieve_depths(const topobag::PinholeCamera<>& camera, const TypicalSizes& sizes,
                       std::vector<FrameRow>& frames) {
  if (sizes.empty()) return;
  for (FrameRow& frame : frames) {
    for (topobag::RangedDetection& detection : frame.detections) {
      const auto typical = sizes.find(detection.label);
      if (typical == sizes.end() || !(detection.z > 0.0)) continue;
      const double seen = detection.z * std::hypot(detection.box.width() / camera.fx,
                                                   detection.box.height() / camera.fy);
      const double factor = seen / std::hypot(typical->second[0], typical->second[1]);
      if (factor > max_size_factor || factor * max_size_factor < 1.0) detection.z = 0.0;
    }
  }
}

}  // namespace program
