// SPDX-License-Identifier: MIT
#include "pose_reading.hpp"

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <sstream>

#include <topobag/sensing/pinhole_camera.hpp>

#include "input_error.hpp"

namespace program {
namespace {

using Sighting = std::map<topobag::ClassId, std::vector<Eigen::Vector3d>>;

/// Where what stands still is in the sensor's frame, by its class.
Sighting objects_of(const FrameRow& frame, const KeyframeOptions& options) {
  Sighting objects;
  const auto add = [&](topobag::ClassId label, double confidence, const Eigen::Vector3d& at) {
    if (confidence < options.min_confidence) return;
    if (options.keep.contains(options.classes.catalog.dynamics(label))) {
      objects[label].push_back(at);
    }
  };
  for (const topobag::RangedDetection& seen : frame.detections) {
    if (seen.z <= 0.0) continue;
    add(seen.label, seen.confidence, options.camera.back_project(seen.box.center(), seen.z));
  }
  for (const topobag::ObjectCluster& seen : frame.clusters) {
    add(seen.label, seen.confidence, seen.centroid);
  }
  return objects;
}

/// An object in two frames.
struct SeenTwice {
  const Eigen::Isometry3d *before, *after;  ///< poses of the frames
  Eigen::Vector3d at_before, at_after;      ///< m, in the sensor's frame
};

std::vector<SeenTwice> seen_twice(const std::vector<FrameRow>& frames,
                                  const KeyframeOptions& options) {
  const double least = 0.35, most = 5.0;  // s between two frames
  const std::size_t enough = 2000;
  std::vector<SeenTwice> pairs;
  const FrameRow* before = nullptr;
  Sighting objects_before;
  for (const FrameRow& frame : frames) {
    if (!frame.T_world_camera || pairs.size() >= enough) continue;
    if (before != nullptr && frame.timestamp - before->timestamp < least) continue;
    Sighting objects = objects_of(frame, options);
    if (before != nullptr && frame.timestamp - before->timestamp < most) {
      for (const auto& [label, at] : objects) {
        const auto known = objects_before.find(label);
        if (at.size() != 1 || known == objects_before.end() || known->second.size() != 1) continue;
        pairs.push_back(
            {&*before->T_world_camera, &*frame.T_world_camera, known->second.front(), at.front()});
      }
    }
    before = &frame;
    objects_before = std::move(objects);
  }
  return pairs;
}

/// How far an object of the second frame lies from where it was, in the middle of all, m.
template <typename Read>
double middle_distance(const std::vector<SeenTwice>& pairs, const Read& read) {
  std::vector<double> distances;
  for (const SeenTwice& pair : pairs) {
    distances.push_back(
        (read(*pair.before) * pair.at_before - read(*pair.after) * pair.at_after).norm());
  }
  const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
  std::nth_element(distances.begin(), middle, distances.end());
  return *middle;
}

Eigen::Isometry3d as_it_is(const Eigen::Isometry3d& pose) { return pose; }

Eigen::Isometry3d read_inverse(const Eigen::Isometry3d& pose) { return pose.inverse(); }

Eigen::Isometry3d read_inverse_w_first(const Eigen::Isometry3d& pose) {
  return read_w_first(pose).inverse();
}

constexpr std::size_t too_few_seen = 20;  // objects seen twice; fewer tell nothing

}  // namespace

Eigen::Isometry3d read_w_first(const Eigen::Isometry3d& pose) {
  const Eigen::Quaterniond read(pose.linear());
  Eigen::Isometry3d other = pose;
  other.linear() = Eigen::Quaterniond(read.x(), read.y(), read.z(), read.w()).toRotationMatrix();
  return other;
}

void require_pose_reading(const std::string& source, const std::vector<FrameRow>& frames,
                          const KeyframeOptions& options) {
  const std::vector<SeenTwice> pairs = seen_twice(frames, options);
  if (pairs.size() < too_few_seen) return;
  struct Reading {
    Eigen::Isometry3d (*read)(const Eigen::Isometry3d&);
    const char* is;
    const char* remedy;
  };
  const char* const w_last = "write the quaternion with w last, qx qy qz qw";
  const char* const inverse = "write the camera's pose in the world, the inverse";
  const double as_read = middle_distance(pairs, as_it_is);
  for (const Reading& other :
       {Reading{read_w_first, "with the quaternion's w first", w_last},
        Reading{read_inverse, "as world to camera", inverse},
        Reading{read_inverse_w_first, "as world to camera with the quaternion's w first",
                "write the camera's pose in the world, the inverse, with w last"}}) {
    const double otherwise = middle_distance(pairs, other.read);
    const double times = 3.0;  // as far: right poses are four times as near as wrong ones
    if (as_read < times * otherwise) continue;
    std::ostringstream why;
    why.precision(2);
    why << "its poses do not bring together what the frames see: from one to the next the "
        << pairs.size() << " objects that can be told lie " << as_read
        << " m apart in the median, and " << otherwise << " m when it is read " << other.is << "; "
        << other.remedy;
    throw InputError(source, why.str());
  }
}

std::string same_poses_text(const std::vector<FrameRow>& frames, const KeyframeOptions& options) {
  const auto first = std::find_if(frames.begin(), frames.end(), [](const FrameRow& frame) {
    return frame.T_world_camera.has_value();
  });
  const bool same =
      first != frames.end() && std::all_of(first, frames.end(), [&](const FrameRow& frame) {
        return !frame.T_world_camera ||
               frame.T_world_camera->matrix() == first->T_world_camera->matrix();
      });
  if (!same) return "";
  const std::vector<SeenTwice> pairs = seen_twice(frames, options);
  if (pairs.size() < too_few_seen) return "";
  const double moved = middle_distance(pairs, as_it_is);
  const double still = 0.1;  // m; of a camera that stands, by the detector and the depth
  if (moved < still) return "";
  std::ostringstream text;
  text.precision(2);
  text << "all poses are the same, and what is seen moves by " << moved
       << " m from frame to frame in the median; leave poses empty where they are not known";
  return text.str();
}

}  // namespace program
