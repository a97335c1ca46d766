// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

/// Matches a key frame's points with the first of a frame's features, wherever the camera is.
template <typename Frame, typename KeyFrame>
void match_in_order(Frame& frame, const KeyFrame& key_frame) {
  const std::size_t count = std::min(frame.mvpMapPoints.size(), key_frame.points.size());
  std::copy_n(key_frame.points.begin(), count, frame.mvpMapPoints.begin());
}

/// Those that are there.
template <typename Point>
int count_matches(const std::vector<Point*>& matches) {
  return static_cast<int>(matches.size()) -
         static_cast<int>(std::count(matches.begin(), matches.end(), nullptr));
}
