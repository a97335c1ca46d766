// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <topobag/graph/detail/rescaled.hpp>
#include <topobag/graph/topology_graph.hpp>
#include <topobag/matching/appearance_model.hpp>
#include <topobag/matching/point_pair.hpp>
#include <topobag/matching/shared_vertical.hpp>
#include <topobag/recognition/changes.hpp>
#include <topobag/recognition/detail/pose_rivals.hpp>
#include <topobag/recognition/detail/stored_entry.hpp>
#include <topobag/recognition/explanation.hpp>
#include <topobag/recognition/recognition.hpp>
#include <topobag/recognition/recognition_options.hpp>
#include <topobag/types/class_catalog.hpp>

namespace topobag {
inline namespace v0 {

namespace detail {

inline std::string class_name(const ClassCatalog& catalog, ClassId label) {
  return catalog.contains(label) ? catalog.name(label) : "class " + std::to_string(value(label));
}

inline std::optional<double> looks_of(const AppearanceModel& model, const Appearance& a,
                                      const Appearance& b) {
  return model.compares(a, b) ? std::make_optional(model.log10_odds(a, b)) : std::nullopt;
}

/// Whether the graphs have the nodes that the report names: a candidate may be another by now.
template <typename Graph>
bool speaks_of(const CandidateReport& report, const Graph& candidate, const Graph& query) {
  if (!report.pose) return true;
  const std::vector<Correspondence>& inliers = report.pose->inliers;
  const std::vector<MissingObject>& missing = report.pose->missing;
  return std::all_of(inliers.begin(), inliers.end(),
                     [&](const Correspondence& pair) {
                       return value(pair.candidate) < candidate.size() &&
                              value(pair.query) < query.size();
                     }) &&
         std::all_of(missing.begin(), missing.end(), [&](const MissingObject& object) {
           return value(object.node) < (object.of_candidate ? candidate : query).size();
         });
}

/// The stages in the order of `judge_candidate`; `best_margin` is the accepted candidate's.
template <typename Graph>
std::vector<ExplainedStage> stages_of(const CandidateReport& report, const Graph& candidate,
                                      const Graph& query, const RecognitionOptions& options,
                                      std::optional<double> best_margin) {
  const double agreeing = report.pose ? static_cast<double>(report.pose->inliers.size()) : 0.0;
  // An unknown scale takes one more, a vertical that both know one less.
  const double needed =
      (options.matching.scale ? 4.0 : 3.0) - (shared_vertical(candidate, query) ? 1.0 : 0.0);
  std::vector<ExplainedStage> stages{
      {"objects that agree", report.pose.has_value(), agreeing, needed, true, {}}};
  if (!report.pose) return stages;
  const auto& pose = *report.pose;
  const MatchOptions& matching = options.matching;
  const double deviation = pose.rotation_deviation();
  stages.push_back({"score", report.margin() >= 0.0, report.score(), report.threshold, true, {}});
  stages.push_back({"spread off a line", pose.spread >= matching.min_spread, pose.spread,
                    matching.min_spread, true, " m"});
  stages.push_back({"deviation of the rotation", deviation <= matching.max_rotation_deviation,
                    deviation, matching.max_rotation_deviation, false, " rad"});
  const RelativePose* nearest = nullptr;  // of the other poses: a rival, or the best supported
  bool rival = false;
  for (const auto& other : report.other_poses) {
    const bool is_one = is_rival(other, pose, query, options.decision);
    if (!is_one && (rival || other.degenerate)) continue;
    if (nearest && is_one == rival && nearest->support() >= other.support()) continue;
    nearest = &other;
    rival = is_one;
  }
  if (nearest && nearest->degenerate) {
    stages.push_back(
        {"score over a degenerate pose", false, pose.score() - nearest->score(), 0.0, true, {}});
  } else if (nearest) {
    stages.push_back({"support over other poses",
                      !rival,
                      pose.support() - nearest->support(),
                      lead_to_ask(*nearest, pose, query, options.decision),
                      true,
                      {}});
  }
  if (report.rival && !report.judged_by) {
    stages.push_back({"support over another place",
                      false,
                      report.support() - report.rival->support,
                      report.rival->lead,
                      true,
                      {}});
  }
  if (report.judged_by) {
    stages.push_back({"first of its place, which is judged for all", false, 0.0, 1.0, true, {}});
  } else if (best_margin && is_verified(report.verdict)) {
    stages.push_back({"lead over the threshold, beside the best one's",
                      report.verdict == Verdict::accepted,
                      report.margin(),
                      *best_margin,
                      true,
                      {}});
  }
  return stages;
}

}  // namespace detail

/// The reasons behind one candidate's verdict.
/// @param options      those of the query
/// @param best_margin  the accepted candidate's, when one was accepted
template <typename Scalar>
CandidateExplanation explain_candidate(const CandidateReport& report,
                                       const TopologyGraph<Scalar>& candidate,
                                       const TopologyGraph<Scalar>& query,
                                       const ClassCatalog& catalog,
                                       const RecognitionOptions& options,
                                       std::optional<double> best_margin = std::nullopt) {
  CandidateExplanation explanation;
  explanation.id = report.id;
  explanation.verdict = report.verdict;
  explanation.similarity = report.similarity;
  explanation.confidence = report.confidence;
  explanation.complete = report.complete;
  explanation.place_support = report.place_support;
  explanation.rival = report.rival;
  explanation.stages = detail::stages_of(report, candidate, query, options, best_margin);
  if (!report.pose) return explanation;
  const RelativePose& pose = *report.pose;
  if (pose.scale_deviation > 0.0) explanation.scale = {pose.scale, pose.scale_deviation};
  const auto name = [&](const auto& node) { return detail::class_name(catalog, node.label); };
  const detail::Rescaled<TopologyGraph<Scalar>> in_metres(query, pose.scale);
  for (const Correspondence& pair : pose.inliers) {
    const auto& there = candidate.node(pair.candidate);
    const auto& here = (*in_metres).node(pair.query);
    const PointPair points = point_pair(there, here, options.matching.consistency.noise);
    explanation.matched.push_back(
        {pair.candidate, pair.query, name(there), name(here),
         points.residual(pose.T_candidate_query).norm(),
         std::sqrt(points.squared_deviation(pose.T_candidate_query)),
         detail::looks_of(appearance_model(options), there.appearance, here.appearance)});
  }
  for (const MissingObject& missing : pose.missing) {
    const auto& node = (missing.of_candidate ? candidate : query).node(missing.node);
    const Eigen::Vector3d position = node.position->template cast<double>();
    explanation.missing.push_back({missing.node, missing.of_candidate, name(node),
                                   missing.of_candidate ? position : pose.in_candidate(position),
                                   missing.views, missing.measured_views, missing.cost});
  }
  if (is_verified(report.verdict)) {
    ChangeOptions changes;
    changes.classes = options.matching.consistency.classes;
    for (const ObjectChange& change : what_changed(candidate, query, pose, changes)) {
      explanation.changes.push_back({change, detail::class_name(catalog, change.label)});
    }
  }
  return explanation;
}

#ifdef TOPOBAG_COMPILED  // it is in the library topobag::compiled
extern template CandidateExplanation explain_candidate(
    const CandidateReport&, const TopologyGraph<double>&, const TopologyGraph<double>&,
    const ClassCatalog&, const RecognitionOptions&, std::optional<double>);
#endif

/// Why `query` was or was not recognised: for the best candidates the stages that each passed and
/// failed, with numbers and objects by name. In one line: `why`.
///
/// @param bag      gives the candidates' graphs; one that is gone since, or has fewer
///                 nodes than its report speaks of, is passed over
/// @param query    the graph that was looked up
/// @param options  those of the query
/// @param max_candidates  that are told of, in the recognition's order: an accepted one is among
///                        the first, whose places were asked
/// O(candidates · n · k).
template <typename Bag>
Explanation explain(const Recognition& recognition, const Bag& bag,
                    const typename Bag::Graph& query, const ClassCatalog& catalog,
                    const RecognitionOptions& options, std::size_t max_candidates = 8) {
  Explanation explanation;
  explanation.objects = query.size();
  explanation.usable = recognition.usable;
  const std::optional<double> best_margin =
      recognition ? std::make_optional(recognition.accepted->margin()) : std::nullopt;
  for (const CandidateReport& report : recognition.candidates) {
    if (explanation.candidates.size() == max_candidates) break;
    const auto candidate = detail::stored_graph(bag, report.id, 0);
    if (!candidate || !detail::speaks_of(report, *candidate, query)) continue;
    explanation.candidates.push_back(
        explain_candidate(report, *candidate, query, catalog, options, best_margin));
  }
  return explanation;
}

}  // namespace v0
}  // namespace topobag
