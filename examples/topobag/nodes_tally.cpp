// SPDX-License-Identifier: MIT
#include "nodes_tally.hpp"

#include <algorithm>
#include <sstream>
#include <utility>
#include <vector>

#include "input_error.hpp"

namespace program {
namespace {

/// "12 of one kind, 1 of another", those that are not 0; "nothing" where all are.
std::string counts_text(const std::vector<std::pair<std::size_t, const char*>>& counts) {
  std::string text;
  for (const auto& [count, kind] : counts) {
    if (count > 0) text += (text.empty() ? "" : ", ") + std::to_string(count) + ' ' + kind;
  }
  return text.empty() ? "nothing" : text;
}

/// The nearest and the farthest known depth of a table, m; both 0 where none is known.
std::pair<double, double> depth_range(const NodeTable& table) {
  std::pair<double, double> range{0.0, 0.0};
  for (const FrameRow& frame : table.frames) {
    for (const topobag::RangedDetection& detection : frame.detections) {
      if (!(detection.z > 0.0)) continue;
      range.first = range.first > 0.0 ? std::min(range.first, detection.z) : detection.z;
      range.second = std::max(range.second, detection.z);
    }
  }
  return range;
}

}  // namespace

NodesTally::NodesTally(const NodeTable& table, const topobag::PinholeCamera<>& camera,
                       const topobag::ClassCatalog& catalog)
    : frames(table.frames.size()) {
  for (const FrameRow& frame : table.frames) {
    const auto lifted = topobag::lift_detections(frame.detections, camera, catalog);
    if (!frame.T_world_camera) ++without_pose;
    detections += frame.detections.size();
    nodes += lifted.nodes.size();
    dropped += lifted.dropped;
  }
}

std::string left_out_text(const RgbdSequence& sequence, const DetectionSource& source,
                          const DetectedNodes& detected) {
  const ImageBoxes none;
  const ImageBoxes& boxes = source.boxes ? *source.boxes : none;
  return counts_text({{sequence.without_depth, "images without a depth image"},
                      {boxes.without_boxes, "images without boxes"},
                      {boxes.other_images, "images that the sequence does not have"},
                      {boxes.empty, "boxes of no size"},
                      {detected.outside, "boxes outside the image"}});
}

std::string nodes_summary(const std::string& set, const NodesTally& tally,
                          const std::string& left_out) {
  std::ostringstream text;
  const topobag::DroppedDetections& dropped = tally.dropped;
  text << set << ": " << tally.frames << " frames, " << tally.detections
       << " detections; with the default filter " << tally.nodes
       << " nodes (left out: " << dropped.invalid << " not valid, " << dropped.low_confidence
       << " of low confidence, " << dropped.dynamic << " dynamic, " << dropped.too_large
       << " too large, " << dropped.no_depth << " without depth, " << dropped.out_of_range
       << " out of range, " << dropped.duplicate << " seen twice)\n"
       << "not in the table: " << left_out << "; frames without a pose: " << tally.without_pose
       << '\n';
  return text.str();
}

void require_depths(const NodesTally& tally, const NodeTable& table) {
  if (tally.nodes > 0 || tally.dropped.out_of_range == 0) return;
  const topobag::LiftOptions lifting;
  const auto [nearest, farthest] = depth_range(table);
  std::ostringstream why;
  why << "none of the " << tally.detections << " detections becomes a node, and "
      << tally.dropped.out_of_range << " have a depth out of range, " << lifting.min_depth << " to "
      << lifting.max_depth << " m: depths are from " << nearest << " to " << farthest
      << " m; give the depth value that means one metre, 5000 in the TUM RGB-D layout";
  throw InputError("--depth-scale", why.str());
}

}  // namespace program
