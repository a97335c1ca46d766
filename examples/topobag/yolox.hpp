// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include <topobag/types/detection.hpp>

namespace program {

/// How detections are read out of a YOLOX network.
struct YoloxOptions {
  int input_size = 416;         ///< side of the network's square input, px
  double min_confidence = 0.1;  ///< objectness times class score of a detection that is kept
  double max_iou = 0.45;        ///< overlap up to which two boxes of one class are two objects
};

/// What a YOLOX network puts out for one image: a row (cx, cy, w, h, objectness, class scores …)
/// per cell of the grids of stride 8, 16 and 32, row by row.
struct YoloxOutput {
  const float* data = nullptr;
  std::size_t rows = 0;
  std::size_t columns = 0;
};

/// The detections of at least the minimum confidence, in px of the network's input, measured from
/// its upper-left corner.
/// @param classes  the class behind each score
/// Throws topobag::InvalidValue when the output's shape does not go with classes and input size.
std::vector<topobag::Detection> decode_yolox(const YoloxOutput& output,
                                             const std::vector<topobag::ClassId>& classes,
                                             const YoloxOptions& options);

/// Drops every detection that overlaps a more confident one of its class by more than `max_iou`.
/// Most confident first, ties in the order given.
std::vector<topobag::Detection> suppress_non_maxima(std::vector<topobag::Detection> detections,
                                                    double max_iou);

}  // namespace program
