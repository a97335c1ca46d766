// SPDX-License-Identifier: MIT
#include "detections.hpp"

namespace python {

std::vector<topobag::BoundingBox> boxes_from(const ArrayLike& boxes, const char* name) {
  const auto given = numbers(boxes, name, {any, 4});
  const auto entry = given.unchecked<2>();
  std::vector<topobag::BoundingBox> found;
  for (py::ssize_t i = 0; i < given.shape(0); ++i) {
    found.push_back({entry(i, 0), entry(i, 1), entry(i, 2), entry(i, 3)});
  }
  return found;
}

py::array_t<double> rows_of_boxes(const std::vector<topobag::BoundingBox>& boxes) {
  py::array_t<double> rows({static_cast<py::ssize_t>(boxes.size()), py::ssize_t{4}});
  double* out = rows.mutable_data();
  for (const topobag::BoundingBox& box : boxes) {
    for (const double edge : {box.x1, box.y1, box.x2, box.y2}) *out++ = edge;
  }
  return rows;
}

std::vector<topobag::RangedDetection> detections_from(
    const ArrayLike& boxes, const ArrayLike& labels, const std::optional<ArrayLike>& scores,
    const std::optional<ArrayLike>& z, const std::optional<ArrayLike>& appearances,
    const py::object& appearance_kind, const std::optional<ArrayLike>& weighted_labels,
    const std::optional<ArrayLike>& label_weights) {
  std::vector<topobag::RangedDetection> detections;
  for (const topobag::BoundingBox& box : boxes_from(boxes)) detections.emplace_back().box = box;
  const auto count = static_cast<py::ssize_t>(detections.size());
  const auto ids = labels_from(labels);
  if (ids.size() != detections.size()) {
    throw topobag::InvalidValue("labels has " + std::to_string(ids.size()) +
                                " rows, but there are " + std::to_string(count) + " boxes");
  }
  for (std::size_t i = 0; i < ids.size(); ++i) detections[i].label = ids[i];
  const auto fill = [&](const std::optional<ArrayLike>& column, const char* name, auto member) {
    if (!column) return;
    const auto given = numbers(*column, name, {any});
    require_rows(given, name, count, "boxes");
    const auto entry = given.unchecked<1>();
    for (py::ssize_t i = 0; i < count; ++i) {
      detections[static_cast<std::size_t>(i)].*member = entry(i);
    }
  };
  fill(scores, "scores", &topobag::RangedDetection::confidence);
  fill(z, "z", &topobag::RangedDetection::z);
  if (appearances) {
    const auto looks = appearances_from(*appearances, appearance_kind, count);
    for (std::size_t i = 0; i < looks.size(); ++i) detections[i].appearance = looks[i];
  }
  const auto weights = label_weights_from(weighted_labels, label_weights, count);
  for (std::size_t i = 0; i < weights.size(); ++i) detections[i].label_weights = weights[i];
  return detections;
}

}  // namespace python
