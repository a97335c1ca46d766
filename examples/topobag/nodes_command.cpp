// SPDX-License-Identifier: MIT
#include <filesystem>
#include <iostream>
#include <map>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include <topobag/sensing/lift_detections.hpp>

#include "box_files.hpp"
#include "camera_option.hpp"
#include "commands.hpp"
#include "csv_reader.hpp"
#include "detect_nodes.hpp"
#include "number_check.hpp"

namespace program {
namespace {

struct NodesOptions {
  std::string images;
  std::string model;
  std::string boxes;
  std::string names;
  std::string out;
  topobag::PinholeCamera<> camera;
  double depth_scale = 5000.0;
  topobag::YoloOptions yolo;
};

/// The class behind each score of the network: COCO's order, or that of a file of names.
std::vector<topobag::ClassId> read_classes(const std::string& names,
                                           const topobag::ClassCatalog& catalog) {
  if (names.empty()) return catalog.ids();
  std::vector<topobag::ClassId> classes;
  std::istringstream lines(read_file(names));
  for (std::string line; std::getline(lines, line);) {
    try {
      classes.push_back(catalog.at(line));
    } catch (const topobag::UnknownClass& unknown) {
      throw InputError(names, classes.size() + 1, unknown.what());
    }
  }
  return classes;
}

/// What became of the detections, and how many make nodes under the library's defaults.
std::string summary(const std::string& set, const NodeTable& table,
                    const topobag::PinholeCamera<>& camera, const topobag::ClassCatalog& catalog) {
  std::size_t detections = 0;
  std::size_t nodes = 0;
  topobag::DroppedDetections dropped;
  for (const FrameRow& frame : table.frames) {
    const auto lifted = topobag::lift_detections(frame.detections, camera, catalog);
    detections += frame.detections.size();
    nodes += lifted.nodes.size();
    dropped += lifted.dropped;
  }
  std::ostringstream text;
  text << set << ": " << table.frames.size() << " frames, " << detections
       << " detections; with the default filter " << nodes
       << " nodes (left out: " << dropped.invalid << " not valid, " << dropped.low_confidence
       << " of low confidence, " << dropped.dynamic << " dynamic, " << dropped.too_large
       << " too large, " << dropped.no_depth << " without depth, " << dropped.out_of_range
       << " out of range, " << dropped.duplicate << " seen twice)\n";
  return text.str();
}

void make_nodes(const NodesOptions& options) {
  const topobag::ClassCatalog catalog = topobag::ClassCatalog::coco80();
  const std::filesystem::path folder = std::filesystem::path(options.out).parent_path();
  if (!folder.empty() && !std::filesystem::is_directory(folder)) {
    throw InputError("--out " + options.out, "the folder does not exist; make it first");
  }
  topobag::PinholeCamera<> camera = options.camera;
  DetectionSource source{options.model, options.yolo, read_classes(options.names, catalog), {}};
  if (!options.boxes.empty()) {
    if (std::filesystem::is_directory(options.boxes) && camera.width == 0) {
      throw InputError("--boxes " + options.boxes,
                       "YOLO files need the image size: give --camera fx,fy,cx,cy,width,height");
    }
    source.boxes = read_boxes(options.boxes, source.classes, catalog, camera.width, camera.height);
  }
  const NodeTable table =
      detect_nodes(read_tum_sequence(options.images), source, options.depth_scale, camera);
  write_node_table(options.out, table, catalog);
  std::cout << summary(options.out, table, camera, catalog);
}

}  // namespace

void add_nodes_command(CLI::App& app) {
  CLI::App& command = *app.add_subcommand(
      "nodes", "Turns RGB-D images into a node table: what a detector sees in them, and how far");
  const auto options = std::make_shared<NodesOptions>();
  command.add_option("--images", options->images, "Sequence in the TUM RGB-D layout")->required();
  CLI::Option_group& detector = *command.add_option_group("detector");
  detector.add_option("--model", options->model, "YOLO network, ONNX");
  detector.add_option("--boxes", options->boxes,
                      "Boxes of another detector: a folder of YOLO text files, or COCO's JSON");
  detector.require_option(1);
  command.add_option("--names", options->names, "Classes of the network, one a line [COCO's 80]");
  command.add_option("--out", options->out, "Table to write: OUT.frames.csv and OUT.nodes.csv")
      ->required();
  add_camera_option(command, "--camera", options->camera,
                    "Intrinsics fx,fy,cx,cy[,width,height], px")
      ->required();
  command.add_option("--depth-scale", options->depth_scale, "Depth value that means one metre")
      ->check(number_within(1e-6))
      ->capture_default_str();
  command.add_option("--head", options->yolo.head, "How the network writes detections down")
      ->transform(CLI::CheckedTransformer(
          std::map<std::string, topobag::YoloHead>{{"yolox", topobag::YoloHead::yolox},
                                                   {"yolov5", topobag::YoloHead::yolov5},
                                                   {"yolov8", topobag::YoloHead::yolov8}},
          CLI::ignore_case))
      ->default_str("yolox");
  command
      .add_option("--min-confidence", options->yolo.min_confidence, "Least score of a detection")
      ->check(number_within(0.0, 1.0))
      ->capture_default_str();
  command.add_option("--nms", options->yolo.max_iou, "Overlap (IoU) of two objects of a class")
      ->check(number_within(0.0, 1.0))
      ->capture_default_str();
  command.add_option("--input-size", options->yolo.input_size, "Side of the network's input, px")
      ->check(CLI::Range(32, 4096))
      ->capture_default_str();
  command.callback([options] { make_nodes(*options); });
}

}  // namespace program
