// SPDX-License-Identifier: MIT
#include <topobag/recognition/recognition_options.hpp>

#include <pybind11/eigen.h>

#include "described_catalog.hpp"
#include "detections.hpp"
#include "fields.hpp"
#include "keyframe_graphs.hpp"
#include "rooms.hpp"
#include "trajectory_array.hpp"

namespace python {
namespace {

using program::FrameRow;
using program::Keyframe;
using program::NodeTable;

/// A detection of a table with its frame's position.
struct TableRow {
  std::uint32_t frame;
  const topobag::RangedDetection* detection;
};

std::vector<TableRow> table_rows(const NodeTable& table) {
  std::vector<TableRow> rows;
  for (std::size_t i = 0; i < table.frames.size(); ++i) {
    for (const auto& detection : table.frames[i].detections) {
      rows.push_back({static_cast<std::uint32_t>(i), &detection});
    }
  }
  return rows;
}

/// A property that is an array with an entry for each frame, or each detection.
template <typename Rows, typename Entry>
auto column(const Rows& rows, const Entry& entry) {
  return [rows, entry](const NodeTable& table) {
    std::vector<std::decay_t<decltype(entry(*rows(table).begin()))>> values;
    for (const auto& row : rows(table)) values.push_back(entry(row));
    return array_from(values);
  };
}

py::array_t<double> poses_of(const NodeTable& table) {
  Eigen::Isometry3d unknown;
  unknown.matrix().setConstant(std::nan(""));
  std::vector<Eigen::Isometry3d> poses;
  for (const FrameRow& frame : table.frames)
    poses.push_back(frame.T_world_camera.value_or(unknown));
  return matrices_of(poses);
}

std::vector<Keyframe> keyframes_from(const std::string& set, const topobag::PinholeCamera<>& camera,
                                     double interval, double window, double min_confidence,
                                     const ClassesArgument& catalog,
                                     const std::optional<Eigen::Vector3d>& world_up,
                                     const std::string& trajectory) {
  program::KeyframeOptions options;
  options.camera = camera;
  options.interval = interval;
  options.window = window;
  options.min_confidence = min_confidence;
  options.classes = object_classes(catalog);
  options.gravity.world_up = world_up;
  options.trajectory = trajectory;
  return program::read_keyframes(set, options);
}

void bind_table(py::module_& module) {
  const auto frames = [](const NodeTable& table) -> const std::vector<FrameRow>& {
    return table.frames;
  };
  py::class_<NodeTable>(module, "NodeTable",
                        "A sequence's frames, and what a detector saw in them, as columns.")
      .def_property_readonly("idx", column(frames, [](const FrameRow& f) { return f.idx; }),
                             "Numbers of the frames (f).")
      .def_property_readonly("stamps",
                             column(frames, [](const FrameRow& f) { return f.timestamp; }),
                             "Times of the frames, s (f).")
      .def_property_readonly("poses", &poses_of,
                             "True poses, camera to world, m (f x 4 x 4); NaN where not known.")
      .def_property_readonly(
          "names",
          [](const NodeTable& table) {
            std::vector<std::string> names;
            for (const FrameRow& frame : table.frames) names.push_back(frame.name);
            return names;
          },
          "Image files of the frames (f).")
      .def_property_readonly("frames",
                             column(table_rows, [](const TableRow& row) { return row.frame; }),
                             "Position among the frames of each detection's (n), ascending.")
      .def_property_readonly(
          "labels",
          column(table_rows,
                 [](const TableRow& row) { return topobag::value(row.detection->label); }),
          "Class ids of the detections (n).")
      .def_property_readonly(
          "scores",
          column(table_rows, [](const TableRow& row) { return row.detection->confidence; }),
          "Detector's scores in [0, 1] (n).")
      .def_property_readonly(
          "z", column(table_rows, [](const TableRow& row) { return row.detection->z; }),
          "Depths, m (n); 0 = unknown.")
      .def_property_readonly(
          "boxes",
          [](const NodeTable& table) {
            std::vector<topobag::BoundingBox> boxes;
            for (const TableRow& row : table_rows(table)) boxes.push_back(row.detection->box);
            return rows_of_boxes(boxes);
          },
          "x1, y1, x2, y2, px (n x 4).")
      .def("__len__", [](const NodeTable& table) { return table.frames.size(); });
  module.def("read_node_table", &program::read_node_table, py::arg("path"),
             py::arg_v("catalog", topobag::ClassCatalog::coco80(), "ClassCatalog.coco80()"),
             "Reads PATH.frames.csv and PATH.nodes.csv. Raises Error with the file and the line.");
}

}  // namespace

void bind_tables(py::module_& module) {
  bind_table(module);
  py::class_<Keyframe>(module, "Keyframe", "A key frame of a table and its graph.")
      .def_readonly("idx", &Keyframe::idx, "Number of the frame in its table.")
      .def_readonly("stamp", &Keyframe::timestamp, "Time, s.")
      .def_readonly("T_world_camera", &Keyframe::T_world_camera,
                    "The true pose, for scoring; None where it is not known.")
      .def_readonly("graph", &Keyframe::graph, "Knows nothing of where in the world it is.")
      .def("__repr__", [](const Keyframe& keyframe) {
        return "<Keyframe " + std::to_string(keyframe.idx) + ": " +
               std::to_string(keyframe.graph.size()) + " nodes>";
      });
  module.def(
      "read_keyframes", &keyframes_from, py::arg("path"), py::arg("camera"), py::kw_only(),
      py::arg("interval") = 0.4, py::arg("window") = 3.0, py::arg("min_confidence") = 0.3,
      py::arg_v("catalog", topobag::ClassCatalog::coco80(), "ClassCatalog.coco80()"),
      py::arg("world_up") = py::none(), py::arg("trajectory") = "",
      py::call_guard<py::gil_scoped_release>(),
      "The key frames of a node table with their graphs, as the program makes them: one each "
      "`interval` s (0 = every frame), fused over `window` s (0 = single frames, with the "
      "paper's edges), of detections with a score of `min_confidence` or more. `world_up` "
      "tells the graphs which way is down; `trajectory` is a file of the frames' poses, "
      "instead of the table's. A `catalog` may say which classes look alike and how large they "
      "are, as a DescribedCatalog. The camera needs its image size. Raises Error with the file.");
}

}  // namespace python
