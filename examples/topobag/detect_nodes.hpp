// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <topobag/adaptors/yolo_heads.hpp>
#include <topobag/sensing/pinhole_camera.hpp>
#include <topobag/types/ids.hpp>

#include "box_files.hpp"
#include "node_table.hpp"
#include "rgbd_sequence.hpp"

namespace program {

/// Where detections come from: a network, or files that another detector wrote.
struct DetectionSource {
  std::string model;                      ///< ONNX file
  topobag::YoloOptions yolo;              ///< of the network
  std::vector<topobag::ClassId> classes;  ///< the class behind each score of the network
  std::optional<ImageBoxes> boxes;        ///< instead of a network, of the same frames
  bool colors = false;                    ///< whether objects are described by their colours
};

/// What was detected in a sequence.
struct DetectedNodes {
  NodeTable table;
  std::size_t outside = 0;  ///< boxes that span less than a pixel of their image, left out
};

/// Detects the objects in a sequence; depths by topobag::RobustBoxDepth. Images are taken as they
/// are stored: an orientation that an EXIF tag asks for is not applied, since depth images have
/// none.
/// @param depth_scale  value / depth_scale = metres
/// @param camera       gets the size of the images where it has none; else they have to agree
/// Throws topobag::Error, also where the program was built without OpenCV.
DetectedNodes detect_nodes(const std::vector<RgbdFrame>& frames, const DetectionSource& source,
                           double depth_scale, topobag::PinholeCamera<>& camera);

}  // namespace program
