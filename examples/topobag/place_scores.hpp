// SPDX-License-Identifier: MIT
#pragma once

#include <topobag/evaluation/labelled_scores.hpp>

#include "recognition_run.hpp"

namespace program {

/// The default's score of every pair: verified where the library verifies it, else by the bag's
/// similarity alone. Precondition: the run keeps what was tried.
topobag::ScoreMatrix place_scores(const RecognitionRun& run);

}  // namespace program
