// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include <topobag/matching/class_groups.hpp>
#include <topobag/types/ids.hpp>

#include "keyframe.hpp"

namespace program {

/// An object of a map in the world: what the key frames that hold it say together.
struct MapObject {
  topobag::ClassId label{};                            ///< that most of them give it
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< m
  Eigen::Vector2d size = Eigen::Vector2d::Zero();      ///< across and along the image's columns, m
  Eigen::Vector3d sight = Eigen::Vector3d::Zero();     ///< mean unit vector of the rays to it
  std::vector<std::size_t> keyframes{};                ///< that hold it, ascending positions
};

/// The objects of a map, and which of them a node is.
struct MapObjects {
  std::vector<MapObject> objects;
  /// [key frame][node]; nothing for a node without a position, or of a key frame without a pose
  std::vector<std::vector<std::optional<std::size_t>>> of_nodes;
};

/// Which nodes are one object in the world.
struct MapObjectOptions {
  double gate = 3.0;          ///< σ within which a node joins an object
  double share = 0.5;         ///< or so near as this share of the smaller one's size
  double max_distance = 1.0;  ///< m; in no case farther
};

/// Joins the nodes of key frames with a pose, in their order: of each key frame the nearest node
/// and object first, each once, where their classes may be one. For the eye: nothing is decided by
/// it. O(nodes · objects within `max_distance`).
MapObjects map_objects(const std::vector<Keyframe>& keyframes, const topobag::ClassGroups& classes,
                       const MapObjectOptions& options = {});

}  // namespace program
