// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include <CLI/CLI.hpp>

#include <Eigen/Core>

#include "camera_option.hpp"
#include "keyframe_graphs.hpp"
#include "recognition_run.hpp"

namespace program {

/// Adds `--camera`, `--image-size`, `--classes`, how key frames are made, which way is up, where
/// their poses come from, what stress the table is put under, and `--progress`.
void add_keyframe_options(CLI::App& command, KeyframeOptions& options, ImageSize& image_size);

/// A map and the key frames to look up in it.
struct MapAndQuery {
  std::string map;  ///< a table, or a saved map
  std::string query;
  topobag::PinholeCamera<> map_camera;          ///< no focal length: that of the query
  std::optional<Eigen::Vector3d> map_world_up;  ///< nothing: that of the query
  std::string map_trajectory{};                 ///< file of the map's poses; empty: the table's
};

/// Adds `--map-camera`, `--map-world-up` and `--map-trajectory`.
void add_map_options(CLI::App& command, MapAndQuery& tables);

/// Reads both tables. Throws InputError.
RecognitionRun read_map_and_query(const MapAndQuery& tables, KeyframeOptions options,
                                  const ImageSize& image_size);

/// Reads a table whose key frames are looked up among themselves. Throws InputError.
RecognitionRun read_sequence(const std::string& nodes, KeyframeOptions options,
                             const ImageSize& image_size);

}  // namespace program
