// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "node_table.hpp"

namespace program {

/// Throws InputError where the camera moves faster from frame to frame, in the middle of all steps,
/// than any vehicle that carries one: the poses are not in metres, or the times not in seconds.
/// @param source  that gave the poses
void require_metres(const std::string& source, const std::vector<FrameRow>& frames);

}  // namespace program
