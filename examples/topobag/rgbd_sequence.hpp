// SPDX-License-Identifier: MIT
#pragma once

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

/// Reads a sequence in the layout of the TUM RGB-D benchmark. Pairs come from associations.txt
/// (time rgb time depth) or, without one, from rgb.txt and depth.txt: the depth image nearest in
/// time, at most 20 ms away. Poses are interpolated in groundtruth.txt where that is there.
/// Throws topobag::Error.
std::vector<RgbdFrame> read_tum_sequence(const std::string& folder);

}  // namespace program
