// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>

#include <topobag/evaluation/place_truth.hpp>
#include <topobag/evaluation/pose_error.hpp>

namespace topobag {
inline namespace v0 {

/// How many accepted matches are worth what as loop constraints: a question apart from retrieval,
/// since two opposite views of one desk are far from the same place and yet make a correct loop.
struct LoopVerdicts {
  std::size_t correct = 0;    ///< within both correct limits
  std::size_t imprecise = 0;  ///< between the limits
  std::size_t wrong = 0;      ///< beyond a wrong limit

  /// Counts one more accepted match.
  void add(PoseVerdict verdict) noexcept {
    ++(verdict == PoseVerdict::correct     ? correct
       : verdict == PoseVerdict::imprecise ? imprecise
                                           : wrong);
  }
  /// All that were counted.
  std::size_t accepted() const noexcept { return correct + imprecise + wrong; }

  /// Valid-loop precision: correct / accepted; undefined when nothing was accepted.
  std::optional<double> precision() const noexcept {
    if (accepted() == 0) return std::nullopt;
    return static_cast<double>(correct) / static_cast<double>(accepted());
  }
};

/// The verdict on the relative pose that a method gives a pair.
/// @param truth  a `PlaceTruth`, or what else has `T_candidate_query(query, candidate)`
template <typename Truth>
PoseVerdict judge_loop(const Truth& truth, std::size_t query, std::size_t candidate,
                       const Eigen::Isometry3d& T_candidate_query, const PoseLimits& limits = {}) {
  return judge(pose_error(truth.T_candidate_query(query, candidate), T_candidate_query), limits);
}

}  // namespace v0
}  // namespace topobag
