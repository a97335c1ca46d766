// SPDX-License-Identifier: MIT
#include "keyframe_graphs.hpp"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>
#include <sstream>
#include <utility>

#include <topobag/edges/delaunay_edges2.hpp>
#include <topobag/edges/knn_edges.hpp>
#include <topobag/graph/local_graph.hpp>
#include <topobag/graph/sight_keyframe.hpp>
#include <topobag/sensing/lift_clusters.hpp>
#include <topobag/sensing/lift_detections.hpp>

#include "cluster_table.hpp"
#include "frame_poses.hpp"
#include "input_error.hpp"
#include "path_kind.hpp"
#include "pose_reading.hpp"
#include "pose_units.hpp"
#include "progress.hpp"
#include "recorded.hpp"
#include "table_checks.hpp"
#include "typical_sizes.hpp"
#include "usual_sizes.hpp"

namespace program {
namespace {

/// For k = 0, 1, … the first frame at or after t0 + k · interval, each at most once.
template <typename Frame>
std::vector<const Frame*> at_interval(const std::vector<Frame>& frames, double interval) {
  const double rounding = 1e-6;  // s; of the stamps' last digit
  std::vector<const Frame*> selected;
  double due = 0.0;
  for (const Frame& frame : frames) {
    const double elapsed = frame.timestamp - frames.front().timestamp + rounding;
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

/// Throws topobag::InvalidValue where the camera is farther from where it was one key frame ago
/// than a graph reaches: one of the two poses is not of this recording.
void require_no_leap(const FrameRow& frame, const Eigen::Isometry3d& T_previous_current) {
  const double farthest = 1048576.0;  // m; 2^20, as far as graphs are kept
  const double distance = T_previous_current.translation().norm();
  if (distance <= farthest) return;
  std::ostringstream why;
  why.precision(3);
  why << "the pose of frame idx " << frame.idx << " is " << distance
      << " m away from that of the key frame before; check tx, ty and tz of both";
  throw topobag::InvalidValue(why.str());
}

/// What a frame of the table shows.
topobag::KeyframeSighting sighting_of(const FrameRow& frame, const KeyframeOptions& options) {
  topobag::KeyframeSighting seen;
  if (options.clusters) {
    topobag::ClusterOptions lifting;
    lifting.min_confidence = options.min_confidence;
    lifting.keep = options.keep;
    seen.stamp = frame.timestamp;
    seen.nodes = topobag::lift_clusters(frame.clusters, topobag::T_graph_forward_left_up(),
                                        options.classes.catalog, lifting)
                     .nodes;
  } else {
    topobag::SightingOptions sighting;
    sighting.lifting = lifting_of(options);
    sighting.max_detections = std::numeric_limits<std::size_t>::max();  // all that the table holds
    seen = topobag::sight_keyframe(frame.timestamp, frame.detections, options.camera,
                                   options.classes.catalog, sighting);
    const topobag::PinholeCamera<>& camera = options.camera;
    if (frame.depth && camera.width > 0) {
      seen.view.depth.emplace(*frame.depth, camera.width, camera.height);
    }
  }
  seen.gravity = frame.gravity;
  return seen;
}

/// A graph of one frame alone.
topobag::TopologyGraph<> single_graph(topobag::KeyframeSighting seen, bool clusters) {
  if (clusters) {
    return topobag::make_topology_graph(std::move(seen.nodes), topobag::KnnEdges{},
                                        {std::move(seen.view)}, seen.gravity);
  }
  return topobag::make_topology_graph(std::move(seen.nodes), topobag::DelaunayEdges2<>{},
                                      {std::move(seen.view)}, seen.gravity);
}

/// What stands still of a map of objects, as its one key frame.
std::vector<Keyframe> read_object_place(const std::string& path, const KeyframeOptions& options) {
  const topobag::ClassCatalog& catalog = options.classes.catalog;
  std::vector<MappedObject> objects =
      read_object_map(path, catalog, options.classes.first_word.value_or(0));
  objects.erase(std::remove_if(objects.begin(), objects.end(),
                               [&](const MappedObject& object) {
                                 return !options.keep.contains(catalog.dynamics(object.label()));
                               }),
                objects.end());
  tell_of_relation(options.objects, path);
  Keyframe place = object_map_place(objects, options.objects);
  if (options.matchable && !place.graph.is_matchable()) {
    throw InputError(path, "it has no three objects that stand still");
  }
  return {std::move(place)};
}

}  // namespace

std::vector<Keyframe> keyframe_graphs(const NodeTable& table, const KeyframeOptions& options) {
  topobag::LocalGraphOptions fusing;
  fusing.window = options.window;
  topobag::LocalGraph<> local(fusing);

  std::vector<Keyframe> keyframes;
  const FrameRow* previous = nullptr;
  const auto selected = at_interval(table.frames, options.interval);
  Progress progress(selected.size(), "key frames made");
  for (const FrameRow* frame : selected) {
    topobag::KeyframeSighting seen = sighting_of(*frame, options);
    Keyframe keyframe{frame->idx, frame->timestamp, frame->T_world_camera, {}, {}};
    if (options.window > 0.0) {
      const Eigen::Isometry3d T_previous_current =
          relative_pose(previous ? *previous : *frame, *frame);
      require_no_leap(*frame, T_previous_current);
      local.add(seen, T_previous_current);
      keyframe.graph = local.graph();
    } else {
      keyframe.graph = single_graph(std::move(seen), options.clusters);
    }
    keyframes.push_back(std::move(keyframe));
    previous = frame;
    progress.step();
  }
  return keyframes;
}

std::vector<Keyframe> read_keyframes(const std::string& set, const KeyframeOptions& options) {
  if (is_object_map(set)) return read_object_place(set, options);
  NodeTable table = options.clusters ? read_cluster_table(set, options.classes.catalog)
                                     : read_node_table(set, options.classes.catalog);
  if (!options.trajectory.empty()) take_poses(options.trajectory, table.frames);
  const std::string poses =
      options.trajectory.empty() ? set_name(set) + ".frames.csv" : options.trajectory;
  require_metres(poses, table.frames);
  require_pose_reading(poses, table.frames, options);
  if (options.clusters) {
    const TableStress& stress = options.stress;
    if (stress.depth_noise > 0.0 || stress.drop > 0.0 || stress.flip > 0.0) {
      throw InputError("--clusters",
                       "--depth-noise, --drop and --flip are for boxes; leave them out");
    }
    for (FrameRow& frame : table.frames) {  // the poses are the sensor's
      if (auto& T = frame.T_world_camera) T = *T * topobag::T_graph_forward_left_up().inverse();
    }
  } else {
    require_in_image(set, table, options);
    disbelieve_depths(options.camera, options.classes.sizes, table.frames);
  }
  apply(options.stress, table);
  apply(options.gravity, Draws{options.stress.seed, options.stress.stream, 1}, table);
  std::vector<Keyframe> keyframes;
  try {
    keyframes = keyframe_graphs(table, options);
  } catch (const topobag::InvalidValue& invalid) {
    throw InputError(poses, invalid.what());
  }
  if (options.matchable) require_usable(set, table, keyframes, options);
  const std::string window = odd_window_text(table.frames, options.window);
  const std::string same = same_poses_text(table.frames, options);
  const std::string doubt =
      options.metric && !options.clusters
          ? size_doubt_text(table.frames, options.camera, options.classes.catalog,
                            options.min_confidence, "are z in metres")
          : "";
  for (const std::string& note : {window, same, doubt}) {
    if (!note.empty()) std::cerr << "topobag: " << set << ": " << note << '\n';
  }
  return keyframes;
}

std::vector<Keyframe> thinned(const std::vector<Keyframe>& keyframes, double interval) {
  std::vector<Keyframe> kept;
  for (const Keyframe* keyframe : at_interval(keyframes, interval)) kept.push_back(*keyframe);
  return kept;
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
