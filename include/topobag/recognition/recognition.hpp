// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <vector>

#include <topobag/matching/relative_pose.hpp>
#include <topobag/recognition/verdict.hpp>
#include <topobag/types/ids.hpp>

namespace topobag {
inline namespace v0 {

/// What became of one candidate.
struct CandidateReport {
  KeyframeId id{};                          ///< of the entry
  double similarity = 0.0;                  ///< of the retrieval, in [0, 1]
  Verdict verdict = Verdict::no_agreement;  ///< how far it came
  std::optional<RelativePose> pose;         ///< the best one that will do, when three objects agree
  std::vector<RelativePose> other_poses;    ///< the other distinct ones, best first
  std::map<ClassId, std::size_t> matched;   ///< matched objects by class (the query's)
  double threshold = 0.0;                   ///< the score that was asked for
  std::optional<double> confidence;         ///< P(true), when the decision is calibrated
  bool complete = true;                     ///< false when the search ended with its budget

  /// By how much the score passed the threshold; negative when it missed.
  double margin() const noexcept { return pose ? pose->score() - threshold : -threshold; }
};

/// The answer to "have I been here, and where exactly?", with the reasons.
struct Recognition {
  std::optional<CandidateReport> accepted;  ///< at most one
  std::vector<CandidateReport> candidates;  ///< all that were tried, best score first
  bool usable = false;                      ///< the query graph has three nodes with a position

  /// Whether a candidate was accepted.
  explicit operator bool() const noexcept { return accepted.has_value(); }
};

}  // namespace v0
}  // namespace topobag
