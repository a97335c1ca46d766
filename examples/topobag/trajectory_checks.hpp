// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>

#include <topobag/evaluation/lifelong_score.hpp>
#include <topobag/evaluation/relative_pose_error.hpp>

// What has to hold of trajectories and of what is asked of them for a score to mean something. Each
// throws InputError where it does not.
namespace program {

/// That a step in frames is no part of one.
void require_whole_frames(const topobag::RelativeStep& step);

/// That more than one pose of the sequence is matched by which the trajectories are aligned.
/// @param estimate  its file
void require_alignable(const std::string& estimate,
                       const std::map<int, topobag::SequenceScore>& scores);

/// That some sequence has two matched poses which are a step apart.
void require_steps(const topobag::RelativeStep& step,
                   const std::map<int, topobag::SequenceScore>& scores);

/// That neither trajectory is the other in millimetres: of its shape, and a thousand times as
/// large.
/// @param groundtruth,estimate  their files
void require_one_unit(const std::string& groundtruth, const std::string& estimate,
                      const std::map<int, topobag::SequenceScore>& scores);

}  // namespace program
