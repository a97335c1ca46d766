// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include <topobag/evaluation/trajectory.hpp>
#include <topobag/graph/topology_graph.hpp>
#include <topobag/sensing/pinhole_camera.hpp>
#include <topobag/types/dynamics.hpp>

#include "node_table.hpp"
#include "table_gravity.hpp"
#include "table_stress.hpp"

namespace program {

/// How the key frames of a table become graphs.
struct KeyframeOptions {
  topobag::PinholeCamera<> camera;  ///< of the table's images, with their size
  double interval = 0.4;            ///< s from one key frame to the next; 0 = every frame
  double window = 3.0;              ///< s of key frames that a graph fuses; 0 = single frames
  double min_confidence = 0.3;      ///< least detector's score
  topobag::DynamicsSet keep{topobag::Dynamics::low,
                            topobag::Dynamics::medium};  ///< dynamic filter: levels that are kept
  TableStress stress{};                                  ///< done to the table by `read_keyframes`
  TableGravity gravity{};  ///< which way is down, told to the table by `read_keyframes`
};

/// A key frame and its graph, which knows nothing of where in the world it is, but for which way is
/// down where the frame knows.
struct Keyframe {
  std::int64_t idx = 0;                             ///< number of the frame in its table
  double timestamp = 0.0;                           ///< s
  std::optional<Eigen::Isometry3d> T_world_camera;  ///< the truth, for scoring alone
  topobag::TopologyGraph<> graph;
};

/// The key frames of a table: for k = 0, 1, … the first frame at or after t0 + k · interval, each
/// at most once. A window fuses the key frames in [t − window, t] by their relative poses; without
/// one, a graph has the paper's edges, Delaunay in the image plane. What frames say of gravity
/// comes along. Throws topobag::InvalidValue when a window lacks a pose.
std::vector<Keyframe> keyframe_graphs(const NodeTable& table, const KeyframeOptions& options);

/// Reads the table, puts it under stress, tells it which way is down, and makes the graphs of its
/// key frames. Throws InputError, also where its boxes are not of the camera's image, and where not
/// one graph is usable.
std::vector<Keyframe> read_keyframes(const std::string& set, const KeyframeOptions& options);

/// The true poses of all key frames; nothing when one is not known.
std::optional<topobag::Trajectory> true_trajectory(const std::vector<Keyframe>& keyframes);

}  // namespace program
