// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>

#include <topobag/evaluation/lifelong_score.hpp>

namespace program {

/// Throws InputError where the rotations of both files go together only when one is read otherwise:
/// with the quaternion's w first, or as world to camera. Turns of both between the same two times
/// tell, whatever their worlds; too few tell nothing.
void require_same_rotations(const std::string& groundtruth, const std::string& estimate,
                            const std::map<int, topobag::SequenceScore>& scores);

}  // namespace program
