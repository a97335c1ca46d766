// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>

#include <topobag/evaluation/lifelong_score.hpp>
#include <topobag/evaluation/relative_pose_error.hpp>

#include "json_output.hpp"

namespace program {

/// What options and output call an alignment, and the unit of a step.
extern const std::map<std::string, topobag::AlignmentModel> alignment_names;
extern const std::map<std::string, topobag::RelativeStep::Unit> step_unit_names;

/// The figures of one sequence.
Json score_json(const topobag::SequenceScore& score, const topobag::RelativeStep& step);

/// By which rules they were made; an infinite limit is null.
Json rules_json(const topobag::LifelongRules& rules, const topobag::RelativeStep& step,
                bool keep_repeated);

/// A row per pose with a true one: its errors.
std::string errors_csv(const std::map<int, topobag::SequenceScore>& scores);

}  // namespace program
