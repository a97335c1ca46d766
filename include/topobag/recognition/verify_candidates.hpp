// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

#include <topobag/bag/query.hpp>
#include <topobag/matching/match_graphs.hpp>
#include <topobag/recognition/detail/place_hypotheses.hpp>
#include <topobag/recognition/detail/pose_rivals.hpp>
#include <topobag/recognition/detail/stored_entry.hpp>
#include <topobag/recognition/recognition.hpp>
#include <topobag/recognition/recognition_options.hpp>

namespace topobag {
inline namespace v0 {

namespace detail {

/// Puts the best pose first that is not degenerate, if it reaches the threshold.
template <typename Pose>
void prefer_determined(std::vector<Pose>& poses, double threshold) {
  const auto determined =
      std::find_if(poses.begin(), poses.end(), [](const Pose& pose) { return !pose.degenerate; });
  if (determined == poses.end() || !(determined->score() >= threshold)) return;
  std::rotate(poses.begin(), determined, determined + 1);
}

/// The stages that a candidate passes by itself; `accepted` when all.
template <typename Graph>
Verdict judge_candidate(const CandidateReport& report, const Graph& query,
                        const DecisionOptions& options) {
  if (!report.pose) return Verdict::no_agreement;
  if (report.pose->degenerate) return Verdict::degenerate;
  if (!(report.margin() >= 0.0)) return Verdict::chance;
  const bool ambiguous =
      std::any_of(report.other_poses.begin(), report.other_poses.end(), [&](const auto& other) {
        return is_rival(other, *report.pose, query, report.believable, options);
      });
  if (ambiguous) return Verdict::ambiguous;
  return report.rival ? Verdict::rivalled : Verdict::accepted;
}

/// What matching says of a candidate.
template <typename Graph>
CandidateReport matched_report(const Candidate& candidate, const Graph& graph, const Graph& query,
                               const MatchOptions& matching, double threshold) {
  CandidateReport report;
  report.id = candidate.id;
  report.similarity = candidate.score;
  report.threshold = threshold;
  GraphMatch match = match_graphs(graph, query, matching);
  report.complete = match.complete;
  prefer_determined(match.poses, threshold);
  if (match.poses.empty()) return report;
  report.pose = std::move(match.poses.front());
  report.other_poses.assign(std::make_move_iterator(match.poses.begin() + 1),
                            std::make_move_iterator(match.poses.end()));
  for (const Correspondence& pair : report.pose->inliers) {
    ++report.matched[query.node(pair.query).label];
  }
  return report;
}

/// Different places of a bag, by its own word; of one that does not tell, every candidate is one.
template <typename Bag>
auto places_of(const Bag& bag, std::size_t, int) -> decltype(std::size_t{bag.places()}) {
  return bag.places();
}
template <typename Bag>
std::size_t places_of(const Bag&, std::size_t candidates, long) {
  return candidates;
}

}  // namespace detail

/// Matches the query with each candidate, judges the best poses again by the places around them,
/// and accepts at most one: the best score among those that pass every stage.
///
/// The places are those of the whole bag, for all of it was asked (`DecisionOptions`). A pose is
/// rivalled when one that puts the query elsewhere in the world fits about as well: in another
/// candidate with a pose in the world, or, without poses, in one of another session or whose id is
/// at least `PlaceOptions::min_id_gap` away.
///
/// Every candidate is matched. What could tell beforehand that one cannot come into question is too
/// weak to pay: in rooms, the best bound that the number of pairs could give leaves out 1 to 13 %
/// of the candidates and 1 to 7 % of the time, that of the largest consistent set less than 1 % of
/// it.
///
/// @param bag         gives the candidates' graphs by `find`, and what is known of them by `info`
/// @param candidates  from `bag.query`
/// Deterministic; ties go to the smaller id.
template <typename Bag>
Recognition verify_candidates(const Bag& bag, const typename Bag::Graph& query,
                              const std::vector<Candidate>& candidates,
                              const RecognitionOptions& options = {}) {
  Recognition recognition;
  recognition.usable = query.is_matchable();
  if (!recognition.usable) return recognition;
  recognition.places = detail::places_of(bag, candidates.size(), 0);
  const double threshold = options.decision.threshold(recognition.places);
  const double believable = options.decision.believable(recognition.places);
  auto& reports = recognition.candidates;
  for (const Candidate& candidate : candidates) {
    const auto graph = detail::stored_graph(bag, candidate.id, 0);
    if (!graph) continue;
    reports.push_back(
        detail::matched_report(candidate, *graph, query, options.matching, threshold));
    reports.back().believable = believable;
  }
  detail::judge_places(bag, query, options, reports);
  for (CandidateReport& report : reports) {
    report.verdict = detail::judge_candidate(report, query, options.decision);
    // A pose that was not judged by its place is of a better one's, or of none among the best.
    const bool passed = report.verdict == Verdict::accepted || report.verdict == Verdict::rivalled;
    if (passed && !report.place_support) report.verdict = Verdict::outdone;
    // A calibration knows the scores of matches with one clear pose, and says nothing of others.
    if (options.decision.calibration && report.place_support &&
        (report.verdict == Verdict::accepted || report.verdict == Verdict::chance)) {
      report.confidence = options.decision.calibration->probability(report.score());
    }
  }
  std::sort(reports.begin(), reports.end(), [](const CandidateReport& a, const CandidateReport& b) {
    const bool a_judged = a.place_support.has_value(), b_judged = b.place_support.has_value();
    if (a_judged != b_judged) return a_judged;
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
