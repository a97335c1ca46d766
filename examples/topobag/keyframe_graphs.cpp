// SPDX-License-Identifier: MIT
#include "keyframe_graphs.hpp"

#include <cmath>
#include <limits>
#include <utility>

#include <topobag/edges/delaunay_edges2.hpp>
#include <topobag/graph/keyframe_sighting.hpp>
#include <topobag/graph/local_graph.hpp>

#include "input_error.hpp"

namespace program {
namespace {

std::vector<const FrameRow*> select_keyframes(const NodeTable& table, double interval) {
  const double rounding = 1e-6;  // s; of the stamps' last digit
  std::vector<const FrameRow*> selected;
  double due = 0.0;
  for (const FrameRow& frame : table.frames) {
    const double elapsed = frame.timestamp - table.frames.front().timestamp + rounding;
    if (elapsed < due) continue;
    selected.push_back(&frame);
    if (interval > 0.0) due = (std::floor(elapsed / interval) + 1.0) * interval;
  }
  return selected;
}

Eigen::Isometry3d relative_pose(const FrameRow& previous, const FrameRow& current) {
  for (const FrameRow* frame : {&previous, &current}) {
    if (!frame->T_world_camera) {
      throw topobag::InvalidValue("frame idx " + std::to_string(frame->idx) +
                                  " has no pose, which a window needs; give --window 0");
    }
  }
  return previous.T_world_camera->inverse() * *current.T_world_camera;
}

}  // namespace

std::vector<Keyframe> keyframe_graphs(const NodeTable& table, const KeyframeOptions& options) {
  const topobag::ClassCatalog catalog = topobag::ClassCatalog::coco80();
  topobag::SightingOptions sighting;
  sighting.lifting.min_confidence = options.min_confidence;
  sighting.lifting.keep = options.keep;
  sighting.max_detections = std::numeric_limits<std::size_t>::max();  // all that the table holds
  topobag::LocalGraphOptions fusing;
  fusing.window = options.window;
  topobag::LocalGraph<> local(fusing);

  std::vector<Keyframe> keyframes;
  const FrameRow* previous = nullptr;
  for (const FrameRow* frame : select_keyframes(table, options.interval)) {
    topobag::KeyframeSighting seen = topobag::sight_keyframe(frame->timestamp, frame->detections,
                                                             options.camera, catalog, sighting);
    Keyframe keyframe{frame->idx, frame->timestamp, frame->T_world_camera, {}};
    if (options.window > 0.0) {
      local.add(seen.stamp, seen.nodes, relative_pose(previous ? *previous : *frame, *frame),
                std::move(seen.view), frame->gravity);
      keyframe.graph = local.graph();
    } else {
      keyframe.graph =
          topobag::make_topology_graph(std::move(seen.nodes), topobag::DelaunayEdges2<>{},
                                       {std::move(seen.view)}, frame->gravity);
    }
    keyframes.push_back(std::move(keyframe));
    previous = frame;
  }
  return keyframes;
}

std::vector<Keyframe> read_keyframes(const std::string& set, const KeyframeOptions& options) {
  NodeTable table = read_node_table(set);
  apply(options.stress, table);
  apply(options.gravity, Draws{options.stress.seed, options.stress.stream, 1}, table);
  try {
    return keyframe_graphs(table, options);
  } catch (const topobag::InvalidValue& invalid) {
    throw InputError(set + ".frames.csv", invalid.what());
  }
}

std::optional<topobag::Trajectory> true_trajectory(const std::vector<Keyframe>& keyframes) {
  topobag::Trajectory trajectory;
  for (const Keyframe& keyframe : keyframes) {
    if (!keyframe.T_world_camera) return std::nullopt;
    trajectory.push_back({keyframe.timestamp, *keyframe.T_world_camera});
  }
  return trajectory;
}

}  // namespace program
