// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

#include <topobag/bag/place_contents.hpp>
#include <topobag/bag/query.hpp>
#include <topobag/fwd.hpp>
#include <topobag/matching/match_graphs.hpp>
#include <topobag/recognition/detail/candidate_verdicts.hpp>
#include <topobag/recognition/detail/learnt_looks.hpp>
#include <topobag/recognition/detail/place_hypotheses.hpp>
#include <topobag/recognition/detail/stored_entry.hpp>
#include <topobag/recognition/recognition.hpp>
#include <topobag/recognition/recognition_options.hpp>

namespace topobag {
inline namespace v0 {

namespace detail {

/// Different places of a bag, by its own word; of one that does not tell, every candidate is one.
template <typename Bag>
auto places_of(const Bag& bag, std::size_t, int) -> decltype(std::size_t{bag.places()}) {
  return bag.places();
}
template <typename Bag>
std::size_t places_of(const Bag&, std::size_t candidates, long) {
  return candidates;
}

/// Those of `all` that can hold such objects; all where the bag does not tell.
template <typename Bag>
auto places_holding(const Bag& bag, const ClassCounts& objects, const ClassGroups& groups,
                    std::size_t, int)
    -> decltype(std::size_t{bag.places_holding(objects, groups)}) {
  return bag.places_holding(objects, groups);
}
template <typename Bag>
std::size_t places_holding(const Bag&, const ClassCounts&, const ClassGroups&, std::size_t all,
                           long) {
  return all;
}

/// The query's matched objects by class.
template <typename Graph>
ClassCounts matched_objects(const RelativePose& pose, const Graph& query) {
  ClassCounts matched;
  for (const Correspondence& pair : pose.inliers) ++matched[query.node(pair.query).label];
  return matched;
}

/// Puts the best pose first that is not degenerate, if it reaches its threshold.
template <typename Pose, typename ThresholdOf>
void prefer_determined(std::vector<Pose>& poses, const ThresholdOf& threshold_of) {
  const auto determined =
      std::find_if(poses.begin(), poses.end(), [](const Pose& pose) { return !pose.degenerate; });
  if (determined == poses.end() || !(determined->score() >= threshold_of(*determined))) return;
  std::rotate(poses.begin(), determined, determined + 1);
}

/// What matching says of a candidate.
/// @param places  of the whole bag
template <typename Bag>
CandidateReport matched_report(const Bag& bag, const Candidate& candidate,
                               const typename Bag::Graph& graph,
                               const KnownDistances<typename Bag::Graph::Scalar>& known,
                               const RecognitionOptions& options, std::size_t places) {
  const typename Bag::Graph& query = known.graph();
  const auto places_for = [&](const ClassCounts& objects) {
    const auto& classes = options.matching.consistency.classes;
    // Which classes an affinity takes for others' is not known beforehand: then every place may.
    if (options.matching.consistency.affinity) return places;
    return std::min(
        places, places_holding(bag, objects, classes, places, 0) + options.decision.more_places);
  };
  const bool with_views = !query.views().empty() || !graph.views().empty();
  const auto threshold = [&](std::size_t asked) {
    return options.decision.threshold(asked, with_views, places);
  };
  CandidateReport report;
  report.id = candidate.id;
  report.similarity = candidate.similarity;
  report.places = places;
  report.with_views = with_views;
  report.threshold = threshold(places);
  GraphMatch match = match_known(graph, known, options.matching);
  report.complete = match.complete;
  if (match.poses.empty()) return report;
  prefer_determined(match.poses, [&](const RelativePose& pose) {
    return threshold(places_for(matched_objects(pose, query)));
  });
  report.pose = std::move(match.poses.front());
  report.other_poses.assign(std::make_move_iterator(match.poses.begin() + 1),
                            std::make_move_iterator(match.poses.end()));
  report.matched = matched_objects(*report.pose, query);
  report.places = places_for(report.matched);
  report.threshold = threshold(report.places);
  return report;
}

}  // namespace detail

/// Matches the query with each candidate, judges the best poses again by the places around them,
/// and accepts at most one: the best score among those that pass every stage.
///
/// What is asked of a score grows with the places of the whole bag that could have given the match,
/// for all of them were asked (`DecisionOptions`). A pose is rivalled when one that puts the query
/// elsewhere in the world fits about as well. Where another candidate stands is told by the world's
/// poses; without them by the map's own objects, as far as these lead from key frame to key frame
/// of one session; where they do not, one of another session is elsewhere, and so is one that is at
/// least `PlaceOptions::min_id_gap` key frames of its session away.
///
/// A bag that does not tell its `places()` is taken for one of as many places as there are
/// candidates: where it holds more, more is accepted falsely than the rate says, and a calibration
/// does not notice that it has grown.
///
/// Every candidate is matched; of what its objects propose, only that is worked out which chance
/// does not explain much better (`MatchOptions::min_promise`). What could tell beforehand that a
/// candidate cannot come into question is too weak to pay: in rooms, the best bound that the number
/// of pairs could give leaves out 1 to 13 % of them and 1 to 7 % of the time (with 64 poses of
/// each), that of the largest consistent set less than 1 % of it.
///
/// A calibration that learnt what looks say is what they are judged by (`appearance_model`); throws
/// InvalidValue where that is of another kind than the bag's looks.
///
/// @param bag         gives the candidates' graphs by `find`, and what is known of them by `info`
/// @param candidates  from `bag.query`
/// Deterministic; ties go to the smaller id.
template <typename Bag, typename Scalar>
Recognition verify_candidates(const Bag& bag, const TopologyGraph<Scalar>& query,
                              const std::vector<Candidate>& candidates,
                              const RecognitionOptions& asked_for = {}) {
  const detail::LearntLooks learnt(bag, asked_for);
  const RecognitionOptions& options = learnt.options();
  Recognition recognition;
  recognition.usable = query.is_matchable();
  if (!recognition.usable) return recognition;
  recognition.places = detail::places_of(bag, candidates.size(), 0);
  const detail::KnownDistances<Scalar> known(query, options.matching.consistency.noise);
  auto& reports = recognition.candidates;
  for (const Candidate& candidate : candidates) {
    const auto graph = detail::stored_graph(bag, candidate.id, 0);
    if (!graph) continue;
    reports.push_back(
        detail::matched_report(bag, candidate, *graph, known, options, recognition.places));
  }
  detail::judge_places(bag, query, options, reports);
  for (CandidateReport& report : reports) {
    report.verdict = detail::judge_candidate(report, query, options.decision);
    // A calibration knows the scores of matches with one clear pose, and says nothing of others.
    if (options.decision.calibration && report.place_support &&
        (report.verdict == Verdict::accepted || report.verdict == Verdict::insignificant)) {
      report.confidence =
          options.decision.calibration->probability(report.score(), recognition.places);
    }
  }
  detail::share_verdicts(reports);
  std::sort(reports.begin(), reports.end(), [](const CandidateReport& a, const CandidateReport& b) {
    const bool a_judged = a.place_support.has_value(), b_judged = b.place_support.has_value();
    if (a_judged != b_judged) return a_judged;
    if (a.margin() != b.margin()) return a.margin() > b.margin();
    return a.id < b.id;
  });
  detail::accept_best(recognition);
  return recognition;
}

#ifdef TOPOBAG_COMPILED  // these are in the library topobag::compiled
extern template Recognition verify_candidates(
    const BagOfTopologyGraphs<TopologyGraph<double>, ClassPairDistanceHistogram>&,
    const TopologyGraph<double>&, const std::vector<Candidate>&, const RecognitionOptions&);
extern template Recognition verify_candidates(const BagView&, const TopologyGraph<double>&,
                                              const std::vector<Candidate>&,
                                              const RecognitionOptions&);
#endif

}  // namespace v0
}  // namespace topobag
