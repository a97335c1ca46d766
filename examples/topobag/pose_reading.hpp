// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "keyframe_graphs.hpp"
#include "node_table.hpp"

namespace program {

/// A pose as it would be had its file the quaternion's w first, where it was read with w last.
Eigen::Isometry3d read_w_first(const Eigen::Isometry3d& pose);

/// Throws InputError where a table's poses bring together what its frames see only when they are
/// read otherwise: with the quaternion's w first, or as world to camera. Objects that are alone of
/// their class in two frames one after the other tell; too few tell nothing.
/// @param source  that gave the poses
void require_pose_reading(const std::string& source, const std::vector<FrameRow>& frames,
                          const KeyframeOptions& options);

/// That all poses are the same while what is seen moves, in a sentence without its full stop; empty
/// where they are not, or it does not.
std::string same_poses_text(const std::vector<FrameRow>& frames, const KeyframeOptions& options);

}  // namespace program
