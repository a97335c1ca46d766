// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include <topobag/sensing/sparse_depth.hpp>

namespace semantic {

/// The features of a frame whose depth the host knows, from its depth camera or its own stereo
/// matching: undistorted pixels and metres. None of a monocular frame.
/// @tparam Frame  ORB-SLAM's Frame or KeyFrame: mvKeysUn (elements with pt.x and pt.y), mvDepth
///                (m, not positive: unknown), one for each feature
template <typename Frame>
std::vector<topobag::DepthPoint> feature_depths(const Frame& frame) {
  std::vector<topobag::DepthPoint> points;
  for (std::size_t i = 0; i < frame.mvDepth.size(); ++i) {
    if (!(frame.mvDepth[i] > 0.0F)) continue;
    const auto& pixel = frame.mvKeysUn[i].pt;
    points.push_back({{pixel.x, pixel.y}, frame.mvDepth[i]});
  }
  return points;
}

}  // namespace semantic
