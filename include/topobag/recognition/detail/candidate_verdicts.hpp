// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include <topobag/recognition/decision_options.hpp>
#include <topobag/recognition/detail/pose_rivals.hpp>
#include <topobag/recognition/recognition.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// The stages that a candidate passes by itself; `accepted` when all.
template <typename Graph>
Verdict judge_candidate(const CandidateReport& report, const Graph& query,
                        const DecisionOptions& options) {
  if (!report.pose) return Verdict::no_agreement;
  if (!(report.margin() >= 0.0)) return Verdict::insignificant;
  if (report.pose->degenerate) return Verdict::degenerate;
  const bool ambiguous =
      std::any_of(report.other_poses.begin(), report.other_poses.end(),
                  [&](const auto& other) { return is_rival(other, *report.pose, query, options); });
  if (ambiguous) return Verdict::ambiguous;
  return report.rival ? Verdict::rivalled : Verdict::accepted;
}

/// What passed by itself, and was not asked of its place, is worth what the better candidate is
/// that was: it shares its verdict, where that is of its place; else it stays rivalled by it.
template <typename Reports>
void share_verdicts(Reports& reports) {
  for (auto& report : reports) {
    const bool passed = report.verdict == Verdict::accepted || report.verdict == Verdict::rivalled;
    if (passed || !report.judged_by) continue;
    report.judged_by.reset();
    report.rival.reset();
  }
  for (auto& report : reports) {
    auto better = &report;
    while (better->judged_by) {  // each by one that scores no less
      better = &*std::find_if(reports.begin(), reports.end(),
                              [&](const auto& other) { return other.id == *better->judged_by; });
    }
    if (better == &report || report.rival) continue;  // judged, or another place is better
    report.verdict = is_verified(better->verdict) ? Verdict::not_best : better->verdict;
    report.rival = better->rival;
  }
}

/// Accepts the first report that passed every stage, with the pose over its place if there is one;
/// the others that passed are not the best.
template <typename Answer>
void accept_best(Answer& recognition) {
  for (auto& report : recognition.candidates) {
    if (report.verdict != Verdict::accepted) continue;
    if (recognition.accepted) {
      report.verdict = Verdict::not_best;
      continue;
    }
    recognition.accepted = report;
    if (report.place_pose) {
      recognition.accepted->pose->T_candidate_query = report.place_pose->T_target_source;
      recognition.accepted->pose->covariance = report.place_pose->covariance;
      recognition.accepted->pose->scale = report.place_scale;
      recognition.accepted->pose->scale_deviation = report.place_scale_deviation;
      recognition.accepted->pose->scale_covariance = report.place_scale_covariance;
    }
  }
}

}  // namespace detail
}  // namespace v0
}  // namespace topobag
