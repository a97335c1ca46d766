// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <topobag/adaptors/yolo_heads.hpp>
#include <topobag/sensing/pinhole_camera.hpp>
#include <topobag/types/ids.hpp>

#include "node_table.hpp"
#include "rgbd_sequence.hpp"

namespace program {

/// Runs a YOLO network over a sequence; depths by topobag::RobustBoxDepth.
/// @param classes      the class behind each score of the network
/// @param depth_scale  value / depth_scale = metres
/// @param camera       gets the size of the images where it has none; else they have to agree
/// Throws InputError, also where the program was built without OpenCV.
NodeTable detect_nodes(const std::vector<RgbdFrame>& frames, const std::string& model,
                       const std::vector<topobag::ClassId>& classes,
                       const topobag::YoloOptions& options, double depth_scale,
                       topobag::PinholeCamera<>& camera);

}  // namespace program
