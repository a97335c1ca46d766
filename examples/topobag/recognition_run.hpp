// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <topobag/evaluation/pose_error.hpp>
#include <topobag/recognition/calibration.hpp>
#include <topobag/recognition/recognition.hpp>

#include "keyframe_graphs.hpp"

namespace program {

/// What came of one key frame that was looked up.
struct LookUp {
  topobag::Recognition recognition;  ///< its ids are positions in the map
  double milliseconds = 0.0;         ///< of the query call alone

  // Of an accepted match:
  std::optional<topobag::PoseError> error;      ///< where both true poses are known
  std::optional<topobag::PoseVerdict> verdict;  ///< where it can be told

  /// Whether there was something to match, and something to match it with.
  bool is_query() const { return recognition.usable && !recognition.candidates.empty(); }
};

/// A decision that errs at a rate, by what was learnt of false matches.
struct CalibratedRun {
  double false_accept_rate = 0.0;
  topobag::Calibration calibration{};
};

/// Key frames looked up in a map.
struct RecognitionRun {
  std::string map_set;
  std::string query_set;
  std::vector<Keyframe> map;
  std::vector<Keyframe> queries;
  std::vector<LookUp> look_ups;               ///< parallel to `queries`
  std::size_t in_map = 0;                     ///< queries that are key frames of the map itself
  std::optional<CalibratedRun> calibrated{};  ///< where the decision was
};

/// The name of a table without its folder.
std::string name_of(const std::string& set);

/// Throws InputError where no key frame could be looked up, and says why.
void require_queries(const RecognitionRun& run);

/// How many of the queries are among the map's key frames: of one time and one graph, as files keep
/// it. They find themselves.
std::size_t count_in_map(const RecognitionRun& run);

/// What an accepted match is held against.
struct Scoring {
  topobag::PoseLimits limits;
  bool different_places = false;  ///< map and query share no place: every accepted match is wrong
};

/// Compares each accepted match with the true poses.
void score(RecognitionRun& run, const Scoring& scoring);

/// The figures of a scored run.
struct RunSummary {
  std::size_t queries = 0;  ///< key frames with a usable graph and a candidate
  std::size_t accepted = 0;
  std::size_t correct = 0;
  std::size_t imprecise = 0;
  std::size_t wrong = 0;
  std::size_t unscored = 0;                          ///< accepted, but the truth is not known
  std::optional<double> median_translation_error_m;  ///< over the accepted with a true pose
  std::optional<double> median_rotation_error_deg;
  std::optional<double> median_query_ms;
};

RunSummary summarize(const RecognitionRun& run);

}  // namespace program
