// SPDX-License-Identifier: MIT
#include "table_checks.hpp"

#include <algorithm>
#include <limits>
#include <sstream>

#include "box_reach.hpp"
#include "input_error.hpp"

namespace program {
namespace {

/// "the 5 key frames", and of how many frames, where an interval left some out.
std::string keyframes_text(std::size_t keyframes, const NodeTable& table,
                           const KeyframeOptions& options) {
  std::ostringstream text;
  text << "the " << keyframes << " key frames";
  if (keyframes < table.frames.size()) {
    text << ", which --keyframe-interval " << options.interval << " leaves of "
         << table.frames.size() << " frames,";
  }
  return text.str();
}

/// From where to where the known depths of a table lie, in words; empty where none is known.
std::string depths_text(const NodeTable& table) {
  double nearest = std::numeric_limits<double>::infinity(), farthest = 0.0;
  for (const FrameRow& frame : table.frames) {
    for (const topobag::RangedDetection& detection : frame.detections) {
      if (detection.z > 0.0) nearest = std::min(nearest, detection.z);
      farthest = std::max(farthest, detection.z);
    }
    for (const topobag::ObjectCluster& cluster : frame.clusters) {
      nearest = std::min(nearest, cluster.centroid.norm());
      farthest = std::max(farthest, cluster.centroid.norm());
    }
  }
  if (farthest == 0.0) return "";
  std::ostringstream text;
  text << " from " << nearest << " to " << farthest << "; are they in metres?";
  return text.str();
}

}  // namespace

topobag::LiftOptions lifting_of(const KeyframeOptions& options) {
  topobag::LiftOptions lifting;
  lifting.min_confidence = options.min_confidence;
  lifting.keep = options.keep;
  return lifting;
}

void require_in_image(const std::string& set, const NodeTable& table,
                      const KeyframeOptions& options) {
  const topobag::PinholeCamera<>& camera = options.camera;
  std::size_t boxes = 0, outside = 0;
  BoxReach beyond(camera.width, camera.height);
  Eigen::Vector2d reach = Eigen::Vector2d::Zero(), first = Eigen::Vector2d::Zero();
  for (const FrameRow& frame : table.frames) {
    for (const topobag::RangedDetection& detection : frame.detections) {
      ++boxes;
      reach = reach.cwiseMax(Eigen::Vector2d(detection.box.x2, detection.box.y2));
      beyond.add(detection.box);
      const Eigen::Vector2d center = detection.box.center();
      if (camera.in_image(center, -0.5)) continue;
      if (++outside == 1) first = center;
    }
  }
  const double furthest = reach.maxCoeff();
  if (furthest > 0.0 && furthest <= 1.0) {
    throw InputError(set_name(set) + ".nodes.csv",
                     "every box lies in [0, 1], as shares of the image do; a table's are in px");
  }
  std::ostringstream why;
  const std::size_t many = 100;
  if (boxes >= many && reach.x() <= 0.5 * camera.width && reach.y() <= 0.5 * camera.height) {
    why << "no box reaches beyond " << reach.x() << " x " << reach.y()
        << " of the camera's image of " << camera.width << " x " << camera.height << " px; give "
        << options.size_options << " of the table's images";
    throw InputError(set_name(set) + ".nodes.csv", why.str());
  }
  if (outside == 0) {
    const std::string form =
        beyond.complaint("u, v are a box's centre and w, h its size, not two corners");
    if (!form.empty()) throw InputError(set_name(set) + ".nodes.csv", form);
    return;
  }
  why << outside << " of " << boxes << " boxes lie outside the camera's image of " << camera.width
      << " x " << camera.height << " px, the first around " << first.x() << ", " << first.y()
      << "; give " << options.size_options << " of the table's images";
  throw InputError(set_name(set) + ".nodes.csv", why.str());
}

void require_usable(const std::string& set, const NodeTable& table,
                    const std::vector<Keyframe>& keyframes, const KeyframeOptions& options) {
  if (std::any_of(keyframes.begin(), keyframes.end(),
                  [](const Keyframe& keyframe) { return keyframe.graph.is_matchable(); })) {
    return;
  }
  if (options.clusters) {
    throw InputError(set_name(set) + ".clusters.csv",
                     "none of " + keyframes_text(keyframes.size(), table, options) +
                         " has three clusters that stand still, in range and above "
                         "--min-confidence; distances are" +
                         depths_text(table));
  }
  topobag::DroppedDetections dropped;
  std::size_t detections = 0;
  for (const FrameRow& frame : table.frames) {
    detections += frame.detections.size();
    dropped += topobag::lift_detections(frame.detections, options.camera, options.classes.catalog,
                                        lifting_of(options))
                   .dropped;
  }
  std::ostringstream why;
  why << "none of " << keyframes_text(keyframes.size(), table, options)
      << " has three objects with a position; ";
  if (detections == 0) {
    why << "there is no detection in the table"
        << (options.stress.drop > 0.0 ? " after --drop" : "");
    throw InputError(set_name(set) + ".nodes.csv", why.str());
  }
  why << "of " << detections << " detections in the table " << dropped.low_confidence
      << " are below --min-confidence, " << dropped.dynamic << " move by themselves, "
      << dropped.no_depth << " have no depth, " << dropped.out_of_range << " are out of range, "
      << dropped.too_large << " too large, " << dropped.invalid << " not valid, "
      << dropped.duplicate << " seen twice";
  const std::size_t ranged =
      detections - dropped.low_confidence - dropped.dynamic - dropped.no_depth;
  if (2 * dropped.out_of_range > ranged) why << "; z are" << depths_text(table);
  throw InputError(set_name(set) + ".nodes.csv", why.str());
}

}  // namespace program
