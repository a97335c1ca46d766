// SPDX-License-Identifier: MIT
#pragma once

namespace semantic {

/// What the host's camera is.
enum class Sensor {
  rgbd,    ///< an image and a depth image
  stereo,  ///< a rectified pair
  mono,    ///< one image: the host's unit is its own
};

}  // namespace semantic
