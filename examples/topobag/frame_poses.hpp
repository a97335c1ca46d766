// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <iostream>
#include <string>
#include <vector>

#include "input_error.hpp"
#include "pose_files.hpp"

namespace program {

/// Gives each frame its pose in the trajectory, interpolated between poses at most 0.1 s apart from
/// it, or none. Throws InputError where not one gets a pose.
/// @param path   of the trajectory, for the error
/// @param frame  has `timestamp`, s, and `T_world_camera`
template <typename Frame>
void give_poses(const std::string& path, const topobag::Trajectory& trajectory,
                std::vector<Frame>& frames) {
  const double max_gap_s = 0.1;
  bool any = false;
  for (Frame& frame : frames) {
    frame.T_world_camera = topobag::pose_at(trajectory, frame.timestamp, max_gap_s);
    any = any || frame.T_world_camera;
  }
  if (any) return;
  throw InputError(path, span_text(trajectory) + " reach none of the images, from " +
                             std::to_string(frames.front().timestamp) + " to " +
                             std::to_string(frames.back().timestamp) +
                             " s; are both of one clock?");
}

/// The same from a file, instead of poses that the frames have; those it does not reach are left
/// out, which stderr tells. Throws InputError.
template <typename Frame>
void take_poses(const std::string& path, std::vector<Frame>& frames) {
  if (!read_pose_file(path).stamped) {
    throw InputError(path,
                     "a KITTI trajectory has no time stamps to find frames by; give TUM's or "
                     "another format that has");
  }
  give_poses(path, read_trajectory(path), frames);
  const std::size_t all = frames.size();
  frames.erase(std::remove_if(frames.begin(), frames.end(),
                              [](const Frame& frame) { return !frame.T_world_camera; }),
               frames.end());
  if (frames.size() == all) return;
  std::cerr << "topobag: " << path << " reaches " << frames.size() << " of " << all
            << " frames; the others are left out\n";
}

}  // namespace program
