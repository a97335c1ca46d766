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

// Each call replaces the run's records; the ids in them are positions in the run's map.
namespace program {

/// At which rate a decision errs, and by what it knows that.
struct CalibrationRequest {
  double false_accept_rate = topobag::DecisionOptions{}.false_accept_rate;
  bool learn = false;  ///< from the map: its poses, other places, or else a null model
  std::vector<Keyframe> other_places{};          ///< key frames that are certainly not of the map
  std::optional<topobag::Calibration> learnt{};  ///< before; then nothing is learnt
  topobag::CalibrationConditions conditions{};   ///< of the run
};

/// Looks every query up in the map, by the library's defaults, or by a decision that is calibrated
/// first.
/// @param leave_out_radius  m; a query is not looked up among key frames whose cameras are nearer:
///                          its own place is then not in the map. Throws InputError when one has no
///                          pose.
void look_up_in_map(RecognitionRun& run, const CalibrationRequest& request = {},
                    std::optional<double> leave_out_radius = std::nullopt);

/// Why a query that was looked up in the map was or was not accepted. Ids are positions in the map.
/// Precondition: the run keeps all reports.
topobag::Explanation explain_look_up(const RecognitionRun& run, std::size_t index);

/// Why the candidate that was accepted for a query was. Precondition: one was.
topobag::CandidateExplanation explain_accepted(const RecognitionRun& run, std::size_t index);

/// Looks every query up among the sequence's key frames that are at least `min_gap` s older. What
/// is learnt is learnt from the whole sequence first. Precondition: the queries are the map's key
/// frames, or some of them in their order.
void look_up_earlier(RecognitionRun& run, double min_gap, const CalibrationRequest& request = {});

/// Verifies each query's own candidates, by the library's defaults, whoever retrieved them.
/// @param candidates  parallel to the run's queries
void verify(RecognitionRun& run, const std::vector<std::vector<topobag::Candidate>>& candidates);

}  // namespace program
