// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <topobag/error.hpp>
#include <topobag/types/detection.hpp>

namespace topobag {
inline namespace v0 {

/// How a YOLO network writes its detections down.
enum class YoloHead {
  yolox,  ///< cells × (cx, cy, w, h, objectness, scores …) relative to grids of stride 8, 16, 32
  yolov5,  ///< boxes × (cx, cy, w, h, objectness, scores …) in px (YOLOv5, v7)
  yolov8,  ///< (cx, cy, w, h, scores …) × boxes in px, no objectness (YOLOv8, 9, 11)
};

/// How detections are got out of a YOLO network.
struct YoloOptions {
  YoloHead head = YoloHead::yolox;  ///< how the output is laid out
  int input_size = 416;             ///< side of the network's square input, px
  double min_confidence = 0.1;      ///< score of a detection that is kept
  double max_iou = 0.45;            ///< overlap up to which two boxes of one class are two objects
};

/// What a network puts out for one image, row by row.
struct NetworkOutput {
  const float* data = nullptr;  ///< row by row; not owned
  std::size_t rows = 0;         ///< of the matrix
  std::size_t columns = 0;      ///< of the matrix
};

namespace detail {

/// A detection's class is the one with the best score, of which there has to be one.
inline void require_classes(const std::vector<ClassId>& classes) {
  if (classes.empty()) {
    throw InvalidValue("the network has no classes: say which class is behind each of its scores");
  }
}

inline void require_shape(const NetworkOutput& output, std::size_t rows, std::size_t columns,
                          const std::string& network) {
  const bool any_rows = rows == 0, any_columns = columns == 0;
  if ((any_rows || output.rows == rows) && (any_columns || output.columns == columns)) return;
  throw InvalidValue("the network gives " + std::to_string(output.rows) + " x " +
                     std::to_string(output.columns) + " numbers; a " + network + " gives " +
                     (any_rows ? "any number of" : std::to_string(rows)) + " x " +
                     (any_columns ? "any number" : std::to_string(columns)));
}

/// Collects what a head writes down, row by row, and sees that it is in the head's units.
class HeadDetections {
 public:
  explicit HeadDetections(double min_confidence) : min_confidence_(min_confidence) {}

  /// Left out when its score is too low or its box empty; NaN is both. Throws InvalidValue for
  /// factors of a score that are no probabilities.
  void add(const Eigen::Vector2d& center, double width, double height, ClassId label,
           double objectness, double score) {
    for (const double factor : {objectness, score}) {
      if (!(factor < -rounding || factor > 1.0 + rounding)) continue;
      throw InvalidValue("the network's score " + std::to_string(factor) +
                         " is no probability: this is another head, or one that was exported "
                         "without its sigmoid");
    }
    const BoundingBox box = box_around(center, width, height);
    if (box.is_valid()) furthest_ = std::max({furthest_, center.maxCoeff(), width, height});
    const double confidence = objectness * score;
    if (!box.is_valid() || !(confidence >= min_confidence_)) return;
    detections_.push_back({box, label, std::clamp(confidence, 0.0, 1.0)});
  }

  /// All of them. Throws InvalidValue where no box of the head reaches beyond the first pixel.
  std::vector<Detection> take() {
    if (!detections_.empty() && furthest_ <= 1.0 + rounding) {
      throw InvalidValue(
          "the network's boxes are shares of its input, not px: export it without normalised "
          "boxes");
    }
    return std::move(detections_);
  }

 private:
  static constexpr double rounding = 1e-3;  // of half precision

  double min_confidence_;
  double furthest_ = 0.0;  ///< px; largest centre, width or height
  std::vector<Detection> detections_;
};

}  // namespace detail

/// The detections in the output of a YOLOX network, in px of its input measured from the input's
/// upper-left corner.
/// @param classes     the class behind each score
/// @param input_size  side of the network's square input, px
/// Throws InvalidValue for no classes, when the output's shape does not go with classes and input
/// size, when a score is no probability, and when the boxes are shares of the input.
inline std::vector<Detection> decode_yolox(const NetworkOutput& output,
                                           const std::vector<ClassId>& classes, int input_size,
                                           double min_confidence) {
  detail::require_classes(classes);
  constexpr std::size_t strides[] = {8, 16, 32};
  const auto input_side = static_cast<std::size_t>(input_size);
  std::size_t cells = 0;
  for (const std::size_t stride : strides) cells += (input_side / stride) * (input_side / stride);
  detail::require_shape(output, cells, 5 + classes.size(),
                        "YOLOX network for images of side " + std::to_string(input_size) + " and " +
                            std::to_string(classes.size()) + " classes");
  detail::HeadDetections detections(min_confidence);
  const float* row = output.data;
  for (const std::size_t stride : strides) {
    const std::size_t side = input_side / stride;
    const auto s = static_cast<double>(stride);
    for (std::size_t cell = 0; cell < side * side; ++cell, row += output.columns) {
      const float* const scores = row + 5;
      const float* const best = std::max_element(scores, scores + classes.size());
      const Eigen::Vector2d grid(static_cast<double>(cell % side),
                                 static_cast<double>(cell / side));
      detections.add((Eigen::Vector2d(row[0], row[1]) + grid) * s,
                     std::exp(static_cast<double>(row[2])) * s,
                     std::exp(static_cast<double>(row[3])) * s,
                     classes[static_cast<std::size_t>(best - scores)], static_cast<double>(row[4]),
                     static_cast<double>(*best));
    }
  }
  return detections.take();
}

/// The same for `YoloHead::yolov5`.
inline std::vector<Detection> decode_yolov5(const NetworkOutput& output,
                                            const std::vector<ClassId>& classes,
                                            double min_confidence) {
  detail::require_classes(classes);
  detail::require_shape(output, 0, 5 + classes.size(),
                        "YOLOv5 network of " + std::to_string(classes.size()) + " classes");
  detail::HeadDetections detections(min_confidence);
  for (std::size_t i = 0; i < output.rows; ++i) {
    const float* const row = output.data + i * output.columns;
    const float* const scores = row + 5;
    const float* const best = std::max_element(scores, scores + classes.size());
    detections.add({row[0], row[1]}, static_cast<double>(row[2]), static_cast<double>(row[3]),
                   classes[static_cast<std::size_t>(best - scores)], static_cast<double>(row[4]),
                   static_cast<double>(*best));
  }
  return detections.take();
}

/// The same for `YoloHead::yolov8`.
inline std::vector<Detection> decode_yolov8(const NetworkOutput& output,
                                            const std::vector<ClassId>& classes,
                                            double min_confidence) {
  detail::require_classes(classes);
  detail::require_shape(output, 4 + classes.size(), 0,
                        "YOLOv8 network of " + std::to_string(classes.size()) + " classes");
  const auto at = [&](std::size_t row, std::size_t box) {
    return static_cast<double>(output.data[row * output.columns + box]);
  };
  detail::HeadDetections detections(min_confidence);
  for (std::size_t box = 0; box < output.columns; ++box) {
    std::size_t best = 0;
    for (std::size_t c = 1; c < classes.size(); ++c) {
      if (at(4 + c, box) > at(4 + best, box)) best = c;
    }
    detections.add({at(0, box), at(1, box)}, at(2, box), at(3, box), classes[best], 1.0,
                   at(4 + best, box));
  }
  return detections.take();
}

}  // namespace v0
}  // namespace topobag
