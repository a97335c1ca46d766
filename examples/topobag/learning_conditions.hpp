// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include <topobag/recognition/calibration.hpp>

#include "keyframe_graphs.hpp"
#include "recognition_run.hpp"

namespace program {

/// What the graphs of a run are made with, as far as scores depend on it, and which map it is.
topobag::CalibrationConditions learning_conditions(const RecognitionRun& run,
                                                   const KeyframeOptions& options);

/// Throws InputError where something was learnt with graphs that were made otherwise: how many
/// objects a graph has decides which scores false matches reach.
/// @param file  that keeps what was learnt
void require_conditions(const std::string& file, const topobag::Calibration& learnt,
                        const topobag::CalibrationConditions& now);

/// Whether it was learnt with another map; nothing where it does not say.
std::optional<bool> is_of_other_map(const topobag::Calibration& learnt,
                                    const topobag::CalibrationConditions& now);

}  // namespace program
