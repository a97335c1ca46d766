// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include <topobag/types/ranged_detection.hpp>

#include "node_array.hpp"

namespace python {

/// Detections from a column each. Throws InvalidValue.
/// @param z  depths, m, where the detections know them
std::vector<topobag::RangedDetection> detections_from(
    const ArrayLike& boxes, const ArrayLike& labels, const std::optional<ArrayLike>& scores,
    const std::optional<ArrayLike>& z, const std::optional<ArrayLike>& appearances,
    const py::object& appearance_kind, const std::optional<ArrayLike>& weighted_labels,
    const std::optional<ArrayLike>& label_weights);

/// Boxes from an n × 4 array x1, y1, x2, y2. Throws InvalidValue.
std::vector<topobag::BoundingBox> boxes_from(const ArrayLike& boxes, const char* name = "boxes");

/// An n × 4 array of them.
py::array_t<double> rows_of_boxes(const std::vector<topobag::BoundingBox>& boxes);

}  // namespace python
