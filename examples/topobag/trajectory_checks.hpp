// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>

#include <topobag/evaluation/lifelong_score.hpp>
#include <topobag/evaluation/openloris_trajectory.hpp>
#include <topobag/evaluation/relative_pose_error.hpp>

// What has to hold of trajectories and of what is asked of them for a score to mean something. Each
// throws InputError where it does not.
namespace program {

/// That a step in frames is no part of one.
void require_whole_frames(const topobag::RelativeStep& step);

/// That as many poses are matched of the sequence by which the trajectories are aligned as settle
/// the alignment: three, for a rotation with or without a scale.
/// @param estimate  its file
void require_alignable(const std::string& estimate,
                       const std::map<int, topobag::SequenceScore>& scores);

/// What a score leaves unsaid: that most poses have no true pose, and that they are so far apart
/// that they hardly count; a sentence a line.
/// @param estimate  its file
std::string score_notes(const std::string& estimate, const topobag::LifelongTrajectories& poses,
                        const std::map<int, topobag::SequenceScore>& scores,
                        const topobag::LifelongRules& rules);

/// That some sequence has two matched poses which are a step apart.
void require_steps(const topobag::RelativeStep& step,
                   const std::map<int, topobag::SequenceScore>& scores);

/// That neither trajectory is the other in millimetres: of its shape, and a thousand times as
/// large.
/// @param groundtruth,estimate  their files
void require_one_unit(const std::string& groundtruth, const std::string& estimate,
                      const std::map<int, topobag::SequenceScore>& scores);

}  // namespace program
