// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>

#include <topobag/sensing/lift_detections.hpp>

#include "detect_nodes.hpp"

namespace program {

/// What was made of a sequence and what was not, and how many nodes the library's defaults make.
struct NodesTally {
  std::size_t frames = 0, without_pose = 0, detections = 0, nodes = 0;
  topobag::DroppedDetections dropped;

  NodesTally(const NodeTable& table, const topobag::PinholeCamera<>& camera,
             const topobag::ClassCatalog& catalog);
};

/// What of a sequence did not come into the table, counted.
std::string left_out_text(const RgbdSequence& sequence, const DetectionSource& source,
                          const DetectedNodes& detected);

/// The two lines that `nodes` prints.
std::string nodes_summary(const std::string& set, const NodesTally& tally,
                          const std::string& left_out);

/// Throws InputError where no detection becomes a node, and depths out of range are among why.
void require_depths(const NodesTally& tally, const NodeTable& table);

}  // namespace program
