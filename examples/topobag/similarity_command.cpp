// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cstdint>
#include <iomanip>
#include <iostream>
#include <memory>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <topobag/bag/bag_of_topology_graphs.hpp>
#include <topobag/sensing/lift_detections.hpp>
#include <topobag/similarity/padded_cosine.hpp>

#include "camera_option.hpp"
#include "commands.hpp"
#include "input_error.hpp"
#include "json_output.hpp"
#include "keyframe_graphs.hpp"
#include "node_table.hpp"
#include "number_check.hpp"

namespace program {
namespace {

/// Table 5 of the paper: key frames 1, 22, 44 and 197 of fr3_walking_xyz, counted from 1.
const std::vector<std::int64_t> paper_frames{0, 21, 43, 196};
const std::array<double, 4> paper_similarities{1.00, 0.95, 0.55, 0.68};

struct SimilarityArguments {
  std::string nodes;
  std::vector<std::int64_t> frames = paper_frames;
  KeyframeOptions keyframes{{}, 0.0, 0.0, 0.3};
  ImageSize image_size;
  double depth_scale = 5000.0;
  bool json = false;
};

/// The frame of number `idx` in its table. Throws InputError.
const Keyframe& frame_of(const std::vector<Keyframe>& frames, std::int64_t idx,
                         const std::string& set) {
  const auto it = std::find_if(frames.begin(), frames.end(),
                               [&](const Keyframe& frame) { return frame.idx == idx; });
  if (it == frames.end()) {
    throw InputError(set + ".frames.csv",
                     "there is no frame idx " + std::to_string(idx) + "; name others by --frames");
  }
  return *it;
}

/// Throws where the frame that the others are compared with shows nothing to compare.
void require_objects(const Keyframe& first, const SimilarityArguments& arguments,
                     const KeyframeOptions& options) {
  if (first.graph.size() > 0) return;
  const topobag::ClassCatalog& catalog = options.classes.catalog;
  topobag::LiftOptions lifting;
  lifting.min_confidence = options.min_confidence;
  lifting.keep = options.keep;
  topobag::DroppedDetections left_out;
  std::size_t detections = 0;
  for (const FrameRow& frame : read_node_table(arguments.nodes, catalog).frames) {
    if (frame.idx != first.idx) continue;
    detections = frame.detections.size();
    left_out = topobag::lift_detections(frame.detections, options.camera, catalog, lifting).dropped;
  }
  std::ostringstream why;
  why << "frame " << first.idx << " has no object to compare the others with; of its " << detections
      << " detections " << left_out.low_confidence << " are below --min-confidence, "
      << left_out.dynamic << " move by themselves, " << left_out.no_depth << " have no depth, "
      << left_out.out_of_range << " are out of range, " << left_out.too_large << " too large, "
      << left_out.invalid << " not valid, " << left_out.duplicate
      << " seen twice; name another frame first";
  throw InputError(set_name(arguments.nodes) + ".nodes.csv", why.str());
}

/// One reading of the paper, or the bag's own similarity.
struct Column {
  const char* name;
  const char* meaning;
  std::vector<double> values{};  ///< of each frame to the first
};

struct SimilarityTable {
  std::vector<const Keyframe*> frames;
  std::vector<Column> columns;
  bool with_paper = false;
};

template <typename Similarity>
void fill(Column& column, const std::vector<const Keyframe*>& frames,
          const Similarity& similarity) {
  for (const Keyframe* frame : frames) {
    column.values.push_back(similarity(frames.front()->graph, frame->graph));
  }
}

SimilarityTable compare(std::vector<const Keyframe*> frames, double depth_scale) {
  using topobag::PaddedCosine;
  using topobag::RowOrder;
  const std::array<std::pair<Column, PaddedCosine>, 4> readings{{
      {{"paper", "eq. 12, rows in the detector's order"}, {RowOrder::detection, 1.0}},
      {{"raw_z", "the same with z as in the depth image"}, {RowOrder::detection, depth_scale}},
      {{"sorted", "rows sorted by class and place"}, {RowOrder::class_then_position, 1.0}},
      {{"assigned", "rows assigned within their class"}, {RowOrder::assignment, 1.0}},
  }};
  SimilarityTable table;
  table.frames = std::move(frames);
  for (const auto& [column, similarity] : readings) {
    table.columns.push_back(column);
    fill(table.columns.back(), table.frames, similarity);
  }
  table.columns.push_back({"default", "the bag's: distances of class pairs"});
  fill(table.columns.back(), table.frames, topobag::BagOfTopologyGraphs<>::Similarity{});
  return table;
}

std::string to_json(const SimilarityTable& table) {
  Json json;
  Json& rows = json["frames"] = Json::array();
  for (std::size_t i = 0; i < table.frames.size(); ++i) {
    Json row{{"frame", table.frames[i]->idx}, {"objects", table.frames[i]->graph.size()}};
    for (const Column& column : table.columns) row[column.name] = column.values[i];
    if (table.with_paper) row["published"] = paper_similarities[i];
    rows.push_back(std::move(row));
  }
  return output_text(json, true);
}

std::string to_text(const SimilarityTable& table) {
  std::ostringstream out;
  const int width = 10;
  out << std::fixed << std::setprecision(2) << std::setw(8) << "frame" << std::setw(width)
      << "objects";
  for (const Column& column : table.columns) out << std::setw(width) << column.name;
  if (table.with_paper) out << std::setw(width + 2) << "published";
  out << '\n';
  for (std::size_t i = 0; i < table.frames.size(); ++i) {
    out << std::setw(8) << table.frames[i]->idx << std::setw(width)
        << table.frames[i]->graph.size();
    for (const Column& column : table.columns) out << std::setw(width) << column.values[i];
    if (table.with_paper) out << std::setw(width + 2) << paper_similarities[i];
    out << '\n';
  }
  out << "\nSimilarity to frame " << table.frames.front()->idx << ".\n";
  for (const Keyframe* frame : table.frames) {
    if (frame->graph.size() > 0) continue;
    out << "Frame " << frame->idx << " has no object: its similarity is 0 by definition.\n";
  }
  for (const Column& column : table.columns) {
    out << "  " << std::left << std::setw(width) << column.name << column.meaning << '\n';
  }
  if (table.with_paper) {
    out << "  " << std::setw(width) << "published"
        << "the paper's Table 5, from its own detections in fr3_walking_xyz\n";
  }
  return out.str();
}

void print_similarities(const SimilarityArguments& arguments) {
  KeyframeOptions options = arguments.keyframes;
  options.matchable = false;
  options.camera = with_size(options.camera, arguments.image_size);
  const std::vector<Keyframe> keyframes = read_keyframes(arguments.nodes, options);
  std::vector<const Keyframe*> frames;
  for (const std::int64_t idx : arguments.frames) {
    frames.push_back(&frame_of(keyframes, idx, arguments.nodes));
  }
  require_objects(*frames.front(), arguments, options);
  const bool one = std::all_of(frames.begin(), frames.end(),
                               [&](const Keyframe* frame) { return frame == frames.front(); });
  if (one) {
    throw InputError("--frames",
                     "it names frame " + std::to_string(frames.front()->idx) +
                         " alone, which is like itself; name others to compare it with");
  }
  SimilarityTable table = compare(std::move(frames), arguments.depth_scale);
  table.with_paper = arguments.frames == paper_frames;
  std::cout << (arguments.json ? to_json(table) : to_text(table));
}

}  // namespace

void add_similarity_command(CLI::App& app) {
  CLI::App& command = *app.add_subcommand(
      "similarity", "Compares frames with the first of them, as in the paper's Table 5");
  const auto arguments = std::make_shared<SimilarityArguments>();
  command.add_option("--nodes", arguments->nodes, "Table: NODES.frames.csv, NODES.nodes.csv")
      ->required();
  command.add_option("--frames", arguments->frames, "idx of the frames, separated by commas")
      ->delimiter(',')
      ->check(frame_number())
      ->default_str("0,21,43,196");
  add_camera_option(command, "--camera", arguments->keyframes.camera,
                    "Intrinsics fx,fy,cx,cy[,width,height], px")
      ->required();
  add_image_size_option(command, arguments->image_size);
  add_classes_option(command, arguments->keyframes.classes);
  command
      .add_option("--min-confidence", arguments->keyframes.min_confidence,
                  "Least score of a detection")
      ->check(number_within(0.0, 1.0))
      ->capture_default_str();
  command
      .add_option("--depth-scale", arguments->depth_scale,
                  "Depth image's value of one metre, for the reading raw_z")
      ->check(number_within(1e-6))
      ->capture_default_str();
  command.add_flag("--json", arguments->json, "Report in JSON");
  command.callback([arguments] { print_similarities(*arguments); });
}

}  // namespace program
