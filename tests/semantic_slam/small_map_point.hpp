// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <opencv2/core.hpp>

/// A point of an ORB-SLAM's map, on a type of our own.
/// @tparam Position  as the host says it
template <typename Position>
struct SmallMapPoint {
  Position position;  ///< in the world
  bool bad = false;

  bool isBad() const { return bad; }
  Position GetWorldPos() const { return position; }
};

/// What an ORB-SLAM's key frame knows of the map points that it sees.
template <typename MapPoint>
struct SmallObservations {
  std::vector<cv::KeyPoint> mvKeysUn;
  std::vector<MapPoint*> map_points;  ///< of each feature; null: none

  std::vector<MapPoint*> GetMapPointMatches() const { return map_points; }
};
