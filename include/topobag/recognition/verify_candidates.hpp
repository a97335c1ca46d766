// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include <topobag/bag/query.hpp>
#include <topobag/matching/match_graphs.hpp>
#include <topobag/recognition/recognition.hpp>

namespace topobag {
inline namespace v0 {

/// When a match is believed. One set for all data; see the README for how it was chosen.
struct DecisionOptions {
  double min_score = 2.0;  ///< −log10 of the odds that chance made the match
  double min_lead = 1.0;    ///< in support, over every other distinct pose in the same candidate
};

namespace detail {

inline Verdict judge_candidate(const CandidateReport& report, const DecisionOptions& options) {
  if (!report.pose) return Verdict::no_agreement;
  if (report.pose->degenerate) return Verdict::degenerate;
  if (report.margin() < 0.0) return Verdict::chance;
  const auto rival = [&](const RelativePose& other) {
    return !other.degenerate && other.support() > report.pose->support() - options.min_lead;
  };
  if (std::any_of(report.other_poses.begin(), report.other_poses.end(), rival))
    return Verdict::ambiguous;
  return Verdict::accepted;
}

}  // namespace detail

/// Matches the query with each candidate and accepts at most one: the best score among those that
/// pass every stage.
///
/// @param bag         gives the candidates' graphs by `find`
/// @param candidates  from `bag.query`
/// Deterministic; ties go to the smaller id.
template <typename Bag>
Recognition verify_candidates(const Bag& bag, const typename Bag::Graph& query,
                              const std::vector<Candidate>& candidates,
                              const MatchOptions& matching = {},
                              const DecisionOptions& decision = {}) {
  Recognition recognition;
  recognition.usable = query.is_matchable();
  if (!recognition.usable) return recognition;
  for (const Candidate& candidate : candidates) {
    const auto graph = bag.find(candidate.id);
    if (!graph) continue;
    CandidateReport report;
    report.id = candidate.id;
    report.similarity = candidate.score;
    report.threshold = decision.min_score;
    GraphMatch match = match_graphs(*graph, query, matching);
    report.complete = match.complete;
    if (!match.poses.empty()) {
      report.pose = std::move(match.poses.front());
      report.other_poses.assign(std::make_move_iterator(match.poses.begin() + 1),
                                std::make_move_iterator(match.poses.end()));
      for (const Correspondence& pair : report.pose->inliers)
        ++report.matched[query.node(pair.query).label];
    }
    report.verdict = detail::judge_candidate(report, decision);
    recognition.candidates.push_back(std::move(report));
  }
  auto& reports = recognition.candidates;
  std::sort(reports.begin(), reports.end(), [](const CandidateReport& a, const CandidateReport& b) {
    if (a.margin() != b.margin()) return a.margin() > b.margin();
    return a.id < b.id;
  });
  for (CandidateReport& report : reports) {
    if (report.verdict != Verdict::accepted) continue;
    if (recognition.accepted) {
      report.verdict = Verdict::outdone;
    } else {
      recognition.accepted = report;
    }
  }
  return recognition;
}

}  // namespace v0
}  // namespace topobag
