// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "json_output.hpp"
#include "recognition_run.hpp"

namespace program {

/// The accepted matches of a run with a place in the world, each with its numbers and a sentence
/// that tells them.
/// @param number_of  what the page calls a key frame of the run's map; nothing: it does not show it
/// @param of_nodes   [key frame of the page][node]: the object of the page that a node is
Json matches_json(const RecognitionRun& run,
                  const std::vector<std::optional<std::size_t>>& number_of,
                  const std::vector<std::vector<std::optional<std::size_t>>>& of_nodes);

}  // namespace program
