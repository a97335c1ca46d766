// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "figure.hpp"
#include "recognition_run.hpp"

namespace program {

/// The drawn graphs of the best accepted match, of the worst that is not wrong, and of the wrong
/// ones with the highest scores.
std::vector<Figure> match_figures(const RecognitionRun& run, std::size_t max_wrong = 6);

}  // namespace program
