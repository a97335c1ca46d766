// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <memory>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <topobag/types/catalog_fingerprint.hpp>

#include "box_files.hpp"
#include "camera_option.hpp"
#include "class_list.hpp"
#include "commands.hpp"
#include "detect_nodes.hpp"
#include "input_error.hpp"
#include "name_check.hpp"
#include "nodes_tally.hpp"
#include "number_check.hpp"
#include "object_classes.hpp"
#include "output_files.hpp"
#include "progress.hpp"
#include "table_lock.hpp"
#include "usual_sizes.hpp"

namespace program {
namespace {

struct NodesOptions {
  std::string images;
  std::string model;
  std::string boxes;
  std::string names;
  std::string out;
  ObjectClasses classes;
  topobag::PinholeCamera<> camera;
  double depth_scale = 5000.0;
  topobag::YoloOptions yolo;
  std::string appearance = "none";  ///< none, color, or layer:NAME
};

const std::string layer_prefix = "layer:";

/// The layer of the network that is to describe objects; empty where none is.
std::string layer_of(const NodesOptions& options) {
  if (options.appearance.rfind(layer_prefix, 0) != 0) return "";
  if (options.model.empty()) {
    throw InputError("--appearance", "a layer is one of the network's: give --model, not --boxes");
  }
  return options.appearance.substr(layer_prefix.size());
}

/// What is wrong with a text that shall say what of an object's looks is kept, in words that a
/// table can hold; the two that are no layer are written small.
std::string appearance_complaint(std::string& text) {
  const std::string small = CLI::detail::to_lower(text);
  if (small == "none" || small == "color") {
    text = small;
    return "";
  }
  const bool layer = text.rfind(layer_prefix, 0) == 0 && text.size() > layer_prefix.size();
  if (layer && text.find_first_of(",\"\r\n") == text.npos) return "";
  return "'" + text + "' is none of none, color and layer:NAME";
}

/// Whether a whole table is there.
bool is_table(const std::string& set) {
  for (const char* ending : {".frames.csv", ".nodes.csv"}) {
    const std::string path = set + ending;
    if (!std::filesystem::is_regular_file(path)) return false;
    std::string header;
    std::getline(std::ifstream(path), header);
    if (header.rfind("idx,", 0) != 0) return false;
  }
  return true;
}

/// Throws InputError where nothing was detected, and says what may be why.
void require_detections(const NodesOptions& options, const NodesTally& tally,
                        const std::string& left_out) {
  if (tally.detections > 0) return;
  std::ostringstream why;
  why << "there is no detection in the " << tally.frames << " images";
  if (!options.model.empty()) {
    why << " above --min-confidence " << options.yolo.min_confidence
        << " (is --head that of the network?)";
  }
  why << "; left out: " << left_out;
  throw InputError(options.model + options.boxes, why.str());
}

/// How many files a folder has, and how large they are together.
std::string files_mark(const std::string& folder) {
  std::uintmax_t files = 0, bytes = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (!entry.is_regular_file()) continue;
    ++files;
    bytes += entry.file_size();
  }
  return std::to_string(files) + ' ' + std::to_string(bytes);
}

/// All that the detections depend on.
std::string text_of(const NodesOptions& options) {
  const topobag::PinholeCamera<>& camera = options.camera;
  const topobag::YoloOptions& yolo = options.yolo;
  std::ostringstream text;
  text.precision(17);
  for (const std::string* file :
       {&options.images, &options.model, &options.boxes, &options.names}) {
    text << *file << ' ';
    if (std::filesystem::is_regular_file(*file)) text << std::filesystem::file_size(*file) << ' ';
  }
  if (std::filesystem::is_directory(options.boxes)) text << files_mark(options.boxes) << ' ';
  text << camera.fx << ' ' << camera.fy << ' ' << camera.cx << ' ' << camera.cy << ' '
       << camera.width << ' ' << camera.height << ' ' << options.depth_scale << ' '
       << static_cast<int>(yolo.head) << ' ' << yolo.min_confidence << ' ' << yolo.max_iou << ' '
       << yolo.input_size << ' ' << options.appearance << ' '
       << topobag::fingerprint(options.classes.catalog);
  return text.str();
}

void make_nodes(const NodesOptions& options) {
  const topobag::ClassCatalog& catalog = options.classes.catalog;
  require_folder("--out", options.out);
  const TableLock lock(options.out);
  if (std::filesystem::is_directory(options.model)) {
    throw InputError(options.model, "it is a folder; name an ONNX file");
  }
  DetectionSource source{
      options.model,
      options.yolo,
      options.names.empty() ? catalog.ids() : read_class_list(options.names, catalog),
      {},
      options.appearance == "color",
      layer_of(options)};
  const RgbdSequence sequence = read_tum_sequence(options.images);
  const bool sized = options.camera.width > 0;
  const topobag::PinholeCamera<> camera =
      with_size(options.camera, sized ? ImageSize{} : size_of_image(sequence.frames.front().rgb));
  if (!options.boxes.empty()) {
    std::vector<std::string> images;
    for (const RgbdFrame& frame : sequence.frames) images.push_back(frame.rgb);
    source.boxes =
        read_boxes(options.boxes, images, {source.classes, catalog, camera.width, camera.height});
  }
  NodesCheckpoint checkpoint(options.out, text_of(options), catalog);
  checkpoint.require_own(sequence.frames);
  const DetectedNodes detected =
      detect_nodes(sequence.frames, source, options.depth_scale, camera, checkpoint);
  const NodesTally tally(detected.table, camera, catalog);
  const std::string left_out = left_out_text(sequence, source, detected);
  require_detections(options, tally, left_out);
  require_depths(tally, detected.table);
  const std::string set = set_name(options.out);
  const bool replaced = is_table(set);
  write_node_table(options.out, detected.table, catalog);
  checkpoint.remove();
  std::cout << nodes_summary(set, tally, left_out);
  if (replaced) std::cerr << "topobag: " << set << ": the table that was there is replaced\n";
  const std::size_t unscored = source.boxes ? source.boxes->unscored : 0;
  if (unscored > 0) {
    std::cerr << "topobag: " << options.boxes << ": " << unscored
              << " boxes have no score, and count as certain\n";
  }
  const std::string doubt =
      size_doubt_text(detected.table.frames, camera, catalog, topobag::LiftOptions{}.min_confidence,
                      "is --depth-scale that of the images");
  if (!doubt.empty()) std::cerr << "topobag: " << set << ": " << doubt << '\n';
}

}  // namespace

void add_nodes_command(CLI::App& app) {
  CLI::App& command = *app.add_subcommand(
      "nodes",
      "Turns RGB-D images into a node table: what a detector sees in them, and how far. The same "
      "command goes on where it was ended");
  const auto options = std::make_shared<NodesOptions>();
  command.add_option("--images", options->images, "Sequence in the TUM RGB-D layout")->required();
  CLI::Option_group& detector = *command.add_option_group("detector");
  CLI::Option* const model = detector.add_option("--model", options->model, "YOLO network, ONNX");
  detector.add_option("--boxes", options->boxes,
                      "Boxes of another detector: a folder of YOLO text files, or COCO's JSON");
  detector.require_option(1);
  command.add_option("--names", options->names,
                     "The classes that the network knows, one a line [all, in their order]");
  add_classes_option(command, options->classes);
  command.add_option("--out", options->out, "Table to write: OUT.frames.csv and OUT.nodes.csv")
      ->required();
  add_camera_option(command, "--camera", options->camera,
                    "Intrinsics fx,fy,cx,cy[,width,height], px")
      ->required();
  command.add_option("--depth-scale", options->depth_scale, "Depth value that means one metre")
      ->check(number_within(1e-6))
      ->capture_default_str();
  command.add_option("--head", options->yolo.head, "How the network writes detections down")
      ->transform(
          one_of(std::map<std::string, topobag::YoloHead>{{"yolox", topobag::YoloHead::yolox},
                                                          {"yolov5", topobag::YoloHead::yolov5},
                                                          {"yolov8", topobag::YoloHead::yolov8}}))
      ->default_str("yolox")
      ->needs(model);
  command
      .add_option("--min-confidence", options->yolo.min_confidence, "Least score of a detection")
      ->check(number_within(0.0, 1.0))
      ->capture_default_str()
      ->needs(model);
  command.add_option("--nms", options->yolo.max_iou, "Overlap (IoU) of two objects of a class")
      ->check(number_within(0.0, 1.0))
      ->capture_default_str()
      ->needs(model);
  command.add_option("--input-size", options->yolo.input_size, "Side of the network's input, px")
      ->check(CLI::Range(32, 4096))
      ->capture_default_str()
      ->needs(model);
  command
      .add_option("--appearance", options->appearance,
                  "What of an object's looks is kept: none, color, or layer:NAME, the features of "
                  "a layer of the network in its box")
      ->transform(CLI::Validator([](std::string& text) { return appearance_complaint(text); },
                                 "none|color|layer:NAME"))
      ->capture_default_str();
  add_progress_option(command);
  command.callback([options] { make_nodes(*options); });
}

}  // namespace program
