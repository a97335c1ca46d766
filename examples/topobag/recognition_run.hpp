// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <topobag/evaluation/pose_error.hpp>
#include <topobag/matching/scale_range.hpp>
#include <topobag/recognition/calibration.hpp>
#include <topobag/recognition/recognition.hpp>

#include "keyframe_graphs.hpp"

namespace program {

/// A candidate of a query as tables tell of it.
struct TriedCandidate {
  std::size_t candidate = 0;  ///< position in the map
  topobag::Verdict verdict = topobag::Verdict::no_agreement;
  std::uint32_t objects = 0;      ///< that agree
  double similarity = 0.0;        ///< of the retrieval
  double place_score = 0.0;       ///< how sure it is that it was taken from about there
  std::optional<double> score{};  ///< of its pose
};

/// What is kept of a query's candidates: a report of each takes kilobytes.
enum class KeptCandidates {
  best,     ///< the report of the best alone
  tried,    ///< that, and a `TriedCandidate` of each
  reports,  ///< every report
};

/// What came of one key frame that was looked up.
struct QueryRecord {
  topobag::Recognition recognition;  ///< its ids are positions in the map; the best candidate
                                     ///< alone, unless all reports are kept
  double milliseconds = 0.0;         ///< of the query call alone

  // Of an accepted match:
  std::optional<topobag::PoseError> error;      ///< where both true poses are known
  std::optional<topobag::PoseVerdict> verdict;  ///< where it can be told
  bool wrong_by_radius = false;                 ///< alone: its pose would not be wrong

  std::vector<TriedCandidate> tried{};  ///< all, best first, where they are kept

  /// Whether there was something to match, and something to match it with.
  bool is_query() const { return recognition.usable && !recognition.candidates.empty(); }

  /// The accepted match, or the candidate that came nearest. Precondition: `is_query()`.
  const topobag::CandidateReport& best() const {
    return recognition.accepted ? *recognition.accepted : recognition.candidates.front();
  }
};

/// A decision that errs at a rate, by what was learnt of false matches.
struct CalibratedRun {
  double false_accept_rate = 0.0;
  topobag::Calibration calibration{};
  std::string looks{};  ///< by what they are judged, in words; empty where there are none to learn
  std::size_t places = 0;           ///< of the map that was looked up in, in the end
  std::optional<bool> other_map{};  ///< learnt with another; nothing where that is not known
};

/// What an accepted match is held against.
struct Scoring {
  topobag::PoseLimits limits;
  bool different_places = false;  ///< map and query share no place: every accepted match is wrong
  std::optional<double> place_radius{};  ///< m; a match of cameras farther apart is wrong
  bool align_worlds = false;             ///< the poses of map and queries are of two worlds
};

/// Key frames looked up in a map.
struct RecognitionRun {
  std::string map_set;
  std::string query_set;
  std::vector<Keyframe> map;
  std::vector<Keyframe> queries;
  KeptCandidates kept = KeptCandidates::best;
  std::vector<QueryRecord> records;            ///< parallel to `queries`
  std::size_t in_map = 0;                      ///< queries that are key frames of the map itself
  std::optional<CalibratedRun> calibrated{};   ///< where the decision was
  ObjectClasses classes{};                     ///< of the map's and the queries' objects
  std::optional<topobag::ScaleRange> scale{};  ///< of the queries' unit, where it is not known

  /// From the queries' world to the map's, where they are two (`align_worlds`); how many of the
  /// accepted matches were correct by it says how far to believe it.
  std::optional<Eigen::Isometry3d> T_map_query_world{};

  double query_interval = 0.0;      ///< s from one query to the next; 0 = every key frame
  std::size_t before_thinning = 0;  ///< queries before that; 0 = not thinned

  std::optional<double> leave_out_radius{};  ///< m; the map's nearer key frames were left out
  std::size_t left_out_of_map = 0;           ///< of those, over all queries

  Scoring scoring{};  ///< by which `score` judged
};

/// Leaves the run the queries that follow each other by at least `interval` s; 0 = all.
void thin_queries(RecognitionRun& run, double interval);

/// The name of a table without its folder.
std::string name_of(const std::string& set);

/// Throws InputError where a key frame of the map or the queries has no pose in the world.
/// @param option  that needs them
void require_poses(const RecognitionRun& run, const std::string& option);

/// Throws InputError where no key frame could be looked up, and says why.
/// @param lacking  what there is nothing to compare with without
void require_queries(const RecognitionRun& run,
                     const std::string& lacking = "a key frame that is older by --min-gap");

/// How many of the queries are of the images of a key frame of the map, of the same time. They find
/// themselves.
std::size_t count_in_map(const RecognitionRun& run);

/// What the truth says of a candidate's pose.
struct JudgedMatch {
  std::optional<topobag::PoseError> error;      ///< where both true poses are known
  std::optional<topobag::PoseVerdict> verdict;  ///< where it can be told
  bool wrong_by_radius = false;                 ///< alone: its pose would not be wrong
};

/// Holds a candidate of a query against the truth. Precondition: it has a pose.
JudgedMatch judge_match(const RecognitionRun& run, std::size_t query,
                        const topobag::CandidateReport& match, const Scoring& scoring);

/// Where the poses of the map and of the queries are of two worlds: the one rigid motion between
/// them by which most accepted matches are correct, of those that one match gives; of equal ones
/// the earliest's. Nothing without an accepted match of two known poses. A match agrees with
/// itself, so that one that is correct says nothing. O(accepted²).
std::optional<Eigen::Isometry3d> aligned_worlds(const RecognitionRun& run,
                                                const topobag::PoseLimits& limits);

/// Compares each accepted match with the true poses, those of the queries brought into the map's
/// world where `scoring` says that they are of another. Throws InputError where a radius is asked
/// for and a pose is not known.
void score(RecognitionRun& run, const Scoring& scoring);

/// What queries took, ms.
struct QueryTimes {
  double median = 0.0;
  double mean = 0.0;
  double percentile_95 = 0.0;  ///< 95 % took no longer
  double worst = 0.0;
};

/// The figures of a scored run.
struct RunSummary {
  std::size_t queries = 0;  ///< key frames with a usable graph and a candidate
  std::size_t accepted = 0;
  std::size_t correct = 0;
  std::size_t imprecise = 0;
  std::size_t wrong = 0;
  std::size_t wrong_by_radius = 0;                   ///< of these: by `Scoring::place_radius` alone
  std::size_t unscored = 0;                          ///< accepted, but the truth is not known
  std::optional<double> median_translation_error_m;  ///< over the accepted with a true pose
  std::optional<double> median_rotation_error_deg;
  std::optional<QueryTimes> query_ms;
};

RunSummary summarize(const RecognitionRun& run);

}  // namespace program
