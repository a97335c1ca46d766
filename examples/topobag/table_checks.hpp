// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <topobag/sensing/lift_detections.hpp>

#include "keyframe_graphs.hpp"

namespace program {

/// Which detections become nodes.
topobag::LiftOptions lifting_of(const KeyframeOptions& options);

/// Throws InputError where the boxes of a table are not in pixels, reach far beyond the
/// image, as corners taken for sizes do, fill one quarter of the camera's image alone, or where the
/// centre of one lies outside it: table and camera are not of one image.
void require_in_image(const std::string& set, const NodeTable& table,
                      const KeyframeOptions& options);

/// Throws InputError where no key frame can be matched, and says what became of the detections.
void require_usable(const std::string& set, const NodeTable& table,
                    const std::vector<Keyframe>& keyframes, const KeyframeOptions& options);

}  // namespace program
