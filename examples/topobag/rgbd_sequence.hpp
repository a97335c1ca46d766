// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Geometry>

namespace program {

/// A colour image and the depth image that goes with it.
struct RgbdFrame {
  double timestamp = 0.0;                           ///< of the colour image, s
  std::string rgb;                                  ///< path
  std::string depth;                                ///< path
  std::optional<Eigen::Isometry3d> T_world_camera;  ///< true pose, m; absent when not known
};

/// A sequence of images, by time.
struct RgbdSequence {
  std::vector<RgbdFrame> frames;
  std::size_t without_depth = 0;  ///< colour images that no depth image is near to
};

/// Reads a sequence in the layout of the TUM RGB-D benchmark. Pairs come from associations.txt
/// (time rgb time depth, at most 0.1 s apart) or, without one, from rgb.txt and depth.txt: the
/// depth image nearest in time, at most 20 ms away. No two colour images are of one time. Poses are
/// interpolated in groundtruth.txt where that is there; it has to reach one image at least. Throws
/// topobag::Error.
RgbdSequence read_tum_sequence(const std::string& folder);

}  // namespace program
