// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <topobag/bag/query.hpp>
#include <topobag/recognition/calibration.hpp>
#include <topobag/recognition/decision_options.hpp>
#include <topobag/recognition/explanation.hpp>

#include "recognition_run.hpp"

// The program's one place that matches graphs, which is slow to compile. Each call replaces the
// run's look-ups; the ids in them are positions in the run's map.
namespace program {

/// At which rate a decision errs, and by what it knows that.
struct CalibrationRequest {
  double false_accept_rate = topobag::DecisionOptions{}.false_accept_rate;
  bool learn = false;  ///< from the map: its poses, other places, or else a null model
  std::vector<Keyframe> other_places{};          ///< key frames that are certainly not of the map
  std::optional<topobag::Calibration> learnt{};  ///< before; then nothing is learnt
};

/// Looks every query up in the whole map, by the library's defaults, or by a decision that is
/// calibrated first.
void look_up_in_map(RecognitionRun& run, const CalibrationRequest& request = {});

/// Why a query that was looked up in the map was or was not accepted. Key frames go by the numbers
/// of their frames.
topobag::Explanation explain_look_up(const RecognitionRun& run, std::size_t index);

/// Looks every key frame of a sequence up among those at least `min_gap` s older. What is learnt is
/// learnt from the whole sequence first. Precondition: map and queries are the same.
void look_up_earlier(RecognitionRun& run, double min_gap, const CalibrationRequest& request = {});

/// Verifies each query's own candidates, by the library's defaults, whoever retrieved them.
/// @param candidates  parallel to the run's queries
void verify(RecognitionRun& run, const std::vector<std::vector<topobag::Candidate>>& candidates);

}  // namespace program
