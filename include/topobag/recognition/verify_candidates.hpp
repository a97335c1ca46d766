// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/Geometry>

#include <topobag/bag/query.hpp>
#include <topobag/matching/match_graphs.hpp>
#include <topobag/recognition/calibration.hpp>
#include <topobag/recognition/recognition.hpp>

namespace topobag {
inline namespace v0 {

/// When a match is believed. One set for all data; see the README for how it was chosen.
struct DecisionOptions {
  double min_score = 0.65;  ///< −log10 of the odds that chance made the match
  double min_lead = 1.0;    ///< in support, over every other distinct pose in the same candidate

  std::optional<Calibration> calibration{};  ///< with it, in place of `min_score`,
  double false_accept_rate = 0.01;           ///< share of look-ups of other places to bear

  /// The score to ask for. Throws InvalidValue when it follows from a rate outside (0, 1].
  double threshold() const {
    return calibration ? calibration->threshold(false_accept_rate).score : min_score;
  }
};

namespace detail {

/// Whether `pose` lies within the 95 % region of a pose that the matched objects leave open.
template <typename Pose>
bool within_uncertainty(const Pose& open, const Pose& pose) {
  const double chi2_95 = 12.5916;  // of six degrees of freedom
  const Eigen::Isometry3d between = pose.T_candidate_query * open.T_candidate_query.inverse();
  const Eigen::AngleAxisd turn(between.linear());
  Eigen::Matrix<double, 6, 1> xi;
  xi << between.translation(), turn.angle() * turn.axis();
  return xi.dot((open.covariance + pose.covariance).ldlt().solve(xi)) <= chi2_95;
}

/// Whether another pose of the candidate keeps `pose` from being believed: it fits about as well. A
/// degenerate pose is no answer itself, but says that the answer is elsewhere if it fits better and
/// does not leave `pose` open.
template <typename Pose>
bool is_rival(const Pose& other, const Pose& pose, double min_lead) {
  if (!other.degenerate) return other.support() > pose.support() - min_lead;
  return other.score() > pose.score() && !within_uncertainty(other, pose);
}

/// Puts the best pose first that is not degenerate, if it reaches the threshold.
template <typename Pose>
void prefer_determined(std::vector<Pose>& poses, double threshold) {
  const auto determined =
      std::find_if(poses.begin(), poses.end(), [](const Pose& pose) { return !pose.degenerate; });
  if (determined == poses.end() || !(determined->score() >= threshold)) return;
  std::rotate(poses.begin(), determined, determined + 1);
}

template <typename Report>
Verdict judge_candidate(const Report& report, const DecisionOptions& options) {
  if (!report.pose) return Verdict::no_agreement;
  if (report.pose->degenerate) return Verdict::degenerate;
  if (!(report.margin() >= 0.0)) return Verdict::chance;
  const bool ambiguous = std::any_of(
      report.other_poses.begin(), report.other_poses.end(),
      [&](const auto& other) { return is_rival(other, *report.pose, options.min_lead); });
  return ambiguous ? Verdict::ambiguous : Verdict::accepted;
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
  const double threshold = decision.threshold();
  for (const Candidate& candidate : candidates) {
    const auto graph = bag.find(candidate.id);
    if (!graph) continue;
    CandidateReport report;
    report.id = candidate.id;
    report.similarity = candidate.score;
    report.threshold = threshold;
    GraphMatch match = match_graphs(*graph, query, matching);
    report.complete = match.complete;
    detail::prefer_determined(match.poses, threshold);
    if (!match.poses.empty()) {
      report.pose = std::move(match.poses.front());
      report.other_poses.assign(std::make_move_iterator(match.poses.begin() + 1),
                                std::make_move_iterator(match.poses.end()));
      for (const Correspondence& pair : report.pose->inliers)
        ++report.matched[query.node(pair.query).label];
    }
    report.verdict = detail::judge_candidate(report, decision);
    // A calibration knows the scores of matches with one clear pose, and says nothing of others.
    if (decision.calibration && report.pose && report.verdict != Verdict::degenerate &&
        report.verdict != Verdict::ambiguous) {
      report.confidence = decision.calibration->probability(report.pose->score());
    }
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
