// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include <topobag/graph/gravity.hpp>
#include <topobag/sensing/depth_grid.hpp>
#include <topobag/sensing/lift_clusters.hpp>
#include <topobag/types/class_catalog.hpp>
#include <topobag/types/ranged_detection.hpp>

namespace program {

/// One image of a sequence and what a detector saw in it.
struct FrameRow {
  std::int64_t idx = 0;                             ///< number of the frame, unique in its table
  std::string name;                                 ///< image file
  double timestamp = 0.0;                           ///< s
  std::optional<Eigen::Isometry3d> T_world_camera;  ///< true pose, m; absent when not known
  std::vector<topobag::RangedDetection> detections;
  std::vector<topobag::ObjectCluster> clusters{};     ///< instead of detections; x forward, z up
  std::optional<topobag::DepthGrid::Levels> depth{};  ///< how far the camera sees
  std::optional<topobag::Gravity<>> gravity;  ///< in its camera's frame; the files do not hold it
};

/// The frames of one sequence, in the order of time.
///
/// A table named SET is two files. `SET.frames.csv` has columns idx, frame, timestamp and
/// optionally the pose tx ty tz qx qy qz qw (camera to world; empty where unknown) and `depth` (see
/// `read_depth`);
/// `SET.nodes.csv` has idx (of the frame), class, conf, u, v (box centre, px), w, h (box size, px),
/// z (m, 0 = unknown) and optionally class_id, which may also stand for class, what else the object
/// may be (`labels`, see `read_labels`), and what it looks like (see `AppearanceColumns`). Further
/// columns are ignored.
struct NodeTable {
  std::vector<FrameRow> frames;
  std::string appearance{};  ///< name of the method that described the objects; empty = none did
};

/// Reads `set`.frames.csv. Throws topobag::Error with the file and the line, also where stamps do
/// not increase or are no seconds (`topobag::require_recording`).
std::vector<FrameRow> read_frames(const std::string& set);

/// The name of a table; each of its files stands for it.
std::string set_name(const std::string& path);

/// Reads `set`.frames.csv and `set`.nodes.csv. Classes go by their name; class_id, where given,
/// has to agree with `catalog`, and is the class where there are no names. Throws topobag::Error
/// with the file and the line.
NodeTable read_node_table(const std::string& set,
                          const topobag::ClassCatalog& catalog = topobag::ClassCatalog::coco80());

/// Writes the two files. Throws InputError.
void write_node_table(const std::string& set, const NodeTable& table,
                      const topobag::ClassCatalog& catalog = topobag::ClassCatalog::coco80());

}  // namespace program
