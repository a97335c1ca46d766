// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <topobag/evaluation/trajectory.hpp>
#include <topobag/sensing/pinhole_camera.hpp>
#include <topobag/types/dynamics.hpp>

#include "keyframe.hpp"
#include "node_table.hpp"
#include "object_classes.hpp"
#include "object_map.hpp"
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
  TableGravity gravity{};      ///< which way is down, told to the table by `read_keyframes`
  std::string trajectory{};    ///< file of the frames' poses, instead of the table's; empty = none
  bool clusters = false;       ///< the table is one of clusters, and there is no camera
  bool metric = true;          ///< the table's lengths are metres
  bool matchable = true;       ///< `read_keyframes` wants a graph that can be matched
  ObjectClasses classes{};     ///< of the table's objects
  ObjectMapOptions objects{};  ///< where a map of objects stands in place of a table
  std::string size_options = "--camera and --image-size";  ///< that tell of the table's images
};

/// The key frames of a table: for k = 0, 1, … the first frame at or after t0 + k · interval, each
/// at most once. A window fuses the key frames in [t − window, t] by their relative poses; without
/// one, a graph has the paper's edges, Delaunay in the image plane, or k nearest for clusters. What
/// frames say of gravity and of how far they see comes along. Throws topobag::InvalidValue when a
/// window lacks a pose.
std::vector<Keyframe> keyframe_graphs(const NodeTable& table, const KeyframeOptions& options);

/// Reads the table, or a map of objects (`is_object_map`), gives it its poses, puts it under
/// stress, tells it which way is down, and makes the graphs of its key frames. Throws InputError,
/// also where its boxes are not of the camera's image, and where not one graph is usable, unless
/// none has to be.
std::vector<Keyframe> read_keyframes(const std::string& set, const KeyframeOptions& options);

/// Those of the key frames that follow each other by at least `interval` s; 0 = all.
std::vector<Keyframe> thinned(const std::vector<Keyframe>& keyframes, double interval);

/// The true poses of all key frames; nothing when one is not known.
std::optional<topobag::Trajectory> true_trajectory(const std::vector<Keyframe>& keyframes);

}  // namespace program
