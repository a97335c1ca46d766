// SPDX-License-Identifier: MIT
#pragma once

#include "json_output.hpp"
#include "recognition_run.hpp"

namespace program {

/// What the page that shows a map draws, in the world's metres and in seconds: classes, objects,
/// key frames with a pose and their graphs, and, of a run that looked key frames up, the accepted
/// matches. Lists of numbers are flat: three or four in a row are a point or a quaternion (x, y, z,
/// w). Throws InputError where no key frame of the map has a pose.
/// @param up  which way is up in the world
Json map_view(const RecognitionRun& run, const topobag::PinholeCamera<>& camera,
              const std::optional<Eigen::Vector3d>& up);

}  // namespace program
