// SPDX-License-Identifier: MIT
#include "yolox.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include <topobag/error.hpp>

namespace program {
namespace {

constexpr std::size_t strides[] = {8, 16, 32};
constexpr std::size_t box_columns = 5;  // cx, cy, w, h, objectness

void require_shape(const YoloxOutput& output, std::size_t input_size, std::size_t classes) {
  std::size_t cells = 0;
  for (const std::size_t stride : strides) cells += (input_size / stride) * (input_size / stride);
  if (output.rows != cells || output.columns != box_columns + classes) {
    throw topobag::InvalidValue(
        "the network gives " + std::to_string(output.rows) + " x " +
        std::to_string(output.columns) + " numbers; a YOLOX network for images of side " +
        std::to_string(input_size) + " and " + std::to_string(classes) + " classes gives " +
        std::to_string(cells) + " x " + std::to_string(box_columns + classes));
  }
}

}  // namespace

std::vector<topobag::Detection> decode_yolox(const YoloxOutput& output,
                                             const std::vector<topobag::ClassId>& classes,
                                             const YoloxOptions& options) {
  const auto input_size = static_cast<std::size_t>(options.input_size);
  require_shape(output, input_size, classes.size());
  std::vector<topobag::Detection> detections;
  const float* row = output.data;
  for (const std::size_t stride : strides) {
    const std::size_t side = input_size / stride;
    for (std::size_t cell = 0; cell < side * side; ++cell, row += output.columns) {
      const float* const scores = row + box_columns;
      const float* const best = std::max_element(scores, scores + classes.size());
      const double confidence = static_cast<double>(row[4]) * static_cast<double>(*best);
      if (!(confidence >= options.min_confidence)) continue;
      const auto s = static_cast<double>(stride);
      const Eigen::Vector2d grid(static_cast<double>(cell % side),
                                 static_cast<double>(cell / side));
      const Eigen::Vector2d center = (Eigen::Vector2d(row[0], row[1]) + grid) * s;
      const topobag::BoundingBox box =
          topobag::box_around(center, std::exp(static_cast<double>(row[2])) * s,
                              std::exp(static_cast<double>(row[3])) * s);
      if (!box.is_valid()) continue;
      detections.push_back(
          {box, classes[static_cast<std::size_t>(best - scores)], std::min(confidence, 1.0)});
    }
  }
  return detections;
}

std::vector<topobag::Detection> suppress_non_maxima(std::vector<topobag::Detection> detections,
                                                    double max_iou) {
  using topobag::Detection;
  std::stable_sort(
      detections.begin(), detections.end(),
      [](const Detection& a, const Detection& b) { return a.confidence > b.confidence; });
  std::vector<Detection> kept;
  for (const Detection& detection : detections) {
    const bool suppressed = std::any_of(kept.begin(), kept.end(), [&](const Detection& better) {
      return better.label == detection.label &&
             topobag::intersection_over_union(better.box, detection.box) > max_iou;
    });
    if (!suppressed) kept.push_back(detection);
  }
  return kept;
}

}  // namespace program
