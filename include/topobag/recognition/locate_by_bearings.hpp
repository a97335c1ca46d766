// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include <topobag/bag/bag_concepts.hpp>
#include <topobag/bag/detail/present_view.hpp>
#include <topobag/bag/place_contents.hpp>
#include <topobag/bag/query.hpp>
#include <topobag/graph/bearing.hpp>
#include <topobag/matching/match_bearings.hpp>
#include <topobag/matching/ranged_bearings.hpp>
#include <topobag/recognition/detail/learnt_looks.hpp>
#include <topobag/recognition/detail/place_hypotheses.hpp>
#include <topobag/recognition/detail/pose_rivals.hpp>
#include <topobag/recognition/detail/stored_entry.hpp>
#include <topobag/recognition/place_graph.hpp>
#include <topobag/recognition/recognition.hpp>
#include <topobag/recognition/recognition_options.hpp>
#include <topobag/recognition/verify_candidates.hpp>
#include <topobag/sensing/sensor_profile.hpp>

namespace topobag {
inline namespace v0 {

namespace detail {

/// The entries that hold most of the bearings' classes: of each group of classes as many objects as
/// both have, over the bearings. O(entries · classes).
template <typename Bag>
std::vector<Candidate> candidates_by_classes(const Bag& bag, const BearingSighting& query,
                                             const QueryOptions& retrieval,
                                             const ClassGroups& groups) {
  const double same_translation = default_sensor.pose_resolution;  // m
  const double same_rotation = 0.5 * rotation_resolution;          // rad
  ClassCounts wanted;
  for (const Bearing& bearing : query.bearings) ++wanted[groups.group(bearing.label)];
  std::vector<Candidate> candidates;
  bag.for_each([&](KeyframeId id, const EntryInfo& info, const typename Bag::Graph& graph) {
    if (!retrieval.admits(id, info)) return;
    ClassCounts held;
    for (const auto& [label, count] : class_counts(graph.nodes()))
      held[groups.group(label)] += count;
    std::size_t common = 0;
    for (const auto& [group, count] : wanted) {
      const auto here = held.find(group);
      if (here != held.end()) common += std::min(count, here->second);
    }
    if (common == 0) return;
    candidates.push_back(
        {id, static_cast<double>(common) / static_cast<double>(query.bearings.size())});
  });
  std::sort(candidates.begin(), candidates.end());
  std::vector<Candidate> kept;
  std::vector<Eigen::Isometry3d> cameras;
  for (const Candidate& candidate : candidates) {
    if (kept.size() == retrieval.max_results) break;
    if (const auto info = stored_info(bag, candidate.id, 0); info && info->T_world_camera) {
      const Eigen::Isometry3d& T = *info->T_world_camera;
      const bool known = std::any_of(cameras.begin(), cameras.end(), [&](const auto& other) {
        return (other.translation() - T.translation()).norm() <= same_translation &&
               Eigen::AngleAxisd(other.linear().transpose() * T.linear()).angle() <= same_rotation;
      });
      if (known) continue;
      cameras.push_back(T);
    }
    kept.push_back(candidate);
  }
  return kept;
}

/// What the bearings say of the place around a candidate.
/// @param place     all objects that the map has there
/// @param places    of the whole bag
template <typename Bag, typename Scalar>
CandidateReport bearings_report(const Bag& bag, const Candidate& candidate,
                                const TopologyGraph<Scalar>& place, const BearingSighting& query,
                                const RecognitionOptions& options, const BearingOptions& bearings,
                                std::size_t places) {
  CandidateReport report;
  report.id = candidate.id;
  report.similarity = candidate.similarity;
  report.places = places;
  report.threshold = options.decision.threshold(places);
  BearingMatch match = match_bearings(place, query, options.matching, bearings);
  report.complete = match.complete;
  if (match.poses.empty()) return report;
  prefer_determined(match.poses, [&](const RelativePose&) { return report.threshold; });
  report.pose = std::move(match.poses.front());
  report.other_poses.assign(std::make_move_iterator(match.poses.begin() + 1),
                            std::make_move_iterator(match.poses.end()));
  for (const Correspondence& pair : report.pose->inliers) {
    ++report.matched[query.bearings[value(pair.query)].label];
  }
  report.places = std::min(
      places, places_holding(bag, report.matched, options.matching.consistency.classes, places, 0) +
                  options.decision.more_places);
  report.threshold = options.decision.threshold(report.places);
  return report;
}

/// Names the place elsewhere that fits best beside each report's pose.
/// @param queries  the bearings with the ranges of each report's pose, parallel to `reports`
template <typename Bag, typename Reports, typename Graphs>
void find_rivals(const Bag& bag, const Graphs& queries, const RecognitionOptions& options,
                 Reports& reports) {
  KeyframeMotion<Bag> motion(bag, options);
  const auto hypotheses = place_hypotheses(bag, motion, reports, options.place);
  for (std::size_t i = 0; i < reports.size(); ++i) {
    auto& report = reports[i];
    if (!report.pose) continue;
    const PlaceHypothesis own{i, &*report.pose, stored_info(bag, report.id, 0),
                              report.pose->support()};
    for (const PlaceHypothesis& other : hypotheses) {
      if (other.report == i) continue;  // told by `other_poses`
      if (same_place(bag, motion, own, other, reports, options.place)) continue;
      const std::size_t elsewhere = objects_put_elsewhere(queries[i], *own.pose, *other.pose,
                                                          seen_from(motion, own, other, reports));
      const double lead = lead_to_ask(elsewhere, other.support, options.decision);
      if (other.support <= own.support - lead) continue;
      if (report.rival && report.rival->support >= other.support) continue;
      report.rival = rival_place(reports[other.report].id, other, lead);
    }
  }
}

}  // namespace detail

/// Where in a map a camera without depth is, by the directions of what it sees: what `Relocalizer`
/// is to nodes with depth.
///
/// The entries that hold most of the bearings' classes are candidates. Each is asked with all
/// objects that the map has around it (`place_graph`), for four or five bearings find less in one
/// image's nodes; the pose is in the candidate's camera frame, and its inliers name nodes of that
/// place. Of key frames at one spot that look the same way, one is asked. Accepted is at most one,
/// as by `verify_candidates`: the threshold for the same rate of false accepts, the same rivals. A
/// decision's calibration is left out, for it was learnt of matches with depth, but for what it
/// says of looks (`appearance_model`).
///
/// @param bag  with `for_each`, `find` and `info`; or a bag with a `view()` that has them
/// Deterministic. O(entries · classes + candidates · (place + triples · pairs)).
template <typename Bag>
Recognition locate_by_bearings(const Bag& bag, const BearingSighting& query,
                               RecognitionOptions options = {},
                               const BearingOptions& bearings = {}) {
  static_assert(is_stored_bag_v<detail::PresentView<Bag>>,
                "topobag: a bag to be asked by bearings has for_each(f) const and size() const, or "
                "a view() that has.");
  const auto map = detail::present_view(bag, 0);
  if (detail::learnt_looks(*map, options)) {
    options.matching.chance.appearance = AppearanceModel(appearance_model(options));
  }
  options.decision.calibration.reset();
  options.decision.surplus += bearings.surplus;
  Recognition recognition;
  recognition.usable = query.bearings.size() >= (query.gravity ? 3U : 4U);
  if (!recognition.usable) return recognition;
  const auto candidates = detail::candidates_by_classes(*map, query, options.retrieval,
                                                        options.matching.consistency.classes);
  recognition.places = detail::places_of(*map, candidates.size(), 0);
  auto& reports = recognition.candidates;
  using Graph = typename detail::PresentView<Bag>::Graph;
  std::vector<Graph> ranged;
  for (const Candidate& candidate : candidates) {
    const auto graph = detail::stored_graph(*map, candidate.id, 0);
    if (!graph) continue;
    const Graph place =
        place_graph(*map, candidate.id, *graph, *graph, Eigen::Isometry3d::Identity(),
                    options.retrieval, options.matching, options.place);
    reports.push_back(detail::bearings_report(*map, candidate, place, query, options, bearings,
                                              recognition.places));
    const auto& pose = reports.back().pose;
    ranged.push_back(pose ? ranged_bearings(query, place, *pose) : Graph());
  }
  detail::find_rivals(*map, ranged, options, reports);
  for (std::size_t i = 0; i < reports.size(); ++i) {
    reports[i].verdict = detail::judge_candidate(reports[i], ranged[i], options.decision);
  }
  std::sort(reports.begin(), reports.end(), [](const CandidateReport& a, const CandidateReport& b) {
    if (a.margin() != b.margin()) return a.margin() > b.margin();
    return a.id < b.id;
  });
  detail::accept_best(recognition);
  return recognition;
}

}  // namespace v0
}  // namespace topobag
