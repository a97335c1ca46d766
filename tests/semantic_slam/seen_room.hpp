// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <vector>

#include <semantic_slam.hpp>

#include "recognition/synthetic_room.hpp"

/// A camera in a room: the boxes that a detector finds in its images.
struct SeenRoom {
  std::vector<topobag::RangedDetection> detect(double stamp) const {
    std::vector<topobag::RangedDetection> found;
    const topobag::TopologyGraph<> seen = room.seen_from(cameras.at(stamp));
    for (const auto& node : seen.nodes()) {
      const Eigen::Vector2d size = 400.0 / node.z * node.size;
      found.push_back({topobag::box_around(*camera.project(*node.position), size.x(), size.y()),
                       topobag::ClassId{topobag::value(node.label) + 56}, 0.9,
                       knows_depth ? node.z : 0.0});
    }
    return found;
  }

  const topobag::PinholeCamera<> camera{400.0, 400.0, 319.5, 239.5, 640, 480};
  const SyntheticRoom room{4, 9, 9};
  std::map<double, Eigen::Isometry3d> cameras;  ///< by the stamp of the image
  bool knows_depth = true;
};
