// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <topobag/adaptors/yolo_heads.hpp>
#include <topobag/sensing/pinhole_camera.hpp>
#include <topobag/types/ids.hpp>

#include "box_files.hpp"
#include "camera_option.hpp"
#include "detected_nodes.hpp"
#include "nodes_checkpoint.hpp"
#include "rgbd_sequence.hpp"

namespace program {

/// Where detections come from: a network, or files that another detector wrote.
struct DetectionSource {
  std::string model;                      ///< ONNX file
  topobag::YoloOptions yolo;              ///< of the network
  std::vector<topobag::ClassId> classes;  ///< the class behind each score of the network
  std::optional<ImageBoxes> boxes;        ///< instead of a network, of the same frames
  bool colors = false;                    ///< whether objects are described by their colours,
  std::string layer{};                    ///< or by this layer of the network; empty = none
};

/// The size of an image file as it is stored. Throws as below.
ImageSize size_of_image(const std::string& path);

/// Detects the objects in a sequence; depths by topobag::RobustBoxDepth. Images are taken as they
/// are stored: an orientation that an EXIF tag asks for is not applied, since depth images have
/// none.
/// @param depth_scale  value / depth_scale = metres
/// @param camera       the images have to be of its size
/// @param checkpoint   says what is done already, and is told of what gets done
/// Throws topobag::Error, also where the program was built without OpenCV.
DetectedNodes detect_nodes(const std::vector<RgbdFrame>& frames, const DetectionSource& source,
                           double depth_scale, const topobag::PinholeCamera<>& camera,
                           NodesCheckpoint& checkpoint);

}  // namespace program
