// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <topobag/recognition/explanation.hpp>

#include "json_output.hpp"
#include "keyframe.hpp"

namespace program {

/// An explanation for machines: every candidate with all its stages, objects and changes.
/// @param map  the key frames that the explanation's ids are positions in
Json to_json(const topobag::Explanation& explanation, const std::vector<Keyframe>& map);

}  // namespace program
