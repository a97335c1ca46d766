// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "json_output.hpp"
#include "recognition_run.hpp"

// What a run was asked for beyond the defaults, and what that left out or made wrong: beside every
// number that depends on it.
namespace program {

/// When an accepted match is wrong: "beyond 1 m or 45°", and how many are by the place's radius
/// alone.
std::string wrong_text(const RecognitionRun& run);

/// Which key frames were left out, of the queries and of the map; empty where none.
std::string left_out_text(const RecognitionRun& run);

/// Both for machines: the keys of what was asked for alone.
Json conditions_json(const RecognitionRun& run);

}  // namespace program
