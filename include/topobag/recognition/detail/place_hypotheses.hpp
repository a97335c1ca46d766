// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Geometry>

#include <topobag/bag/entry_info.hpp>
#include <topobag/graph/detail/rescaled.hpp>
#include <topobag/matching/judge_pose.hpp>
#include <topobag/matching/relative_pose.hpp>
#include <topobag/recognition/detail/pose_rivals.hpp>
#include <topobag/recognition/detail/stored_entry.hpp>
#include <topobag/recognition/place_graph.hpp>
#include <topobag/recognition/recognition.hpp>
#include <topobag/recognition/recognition_options.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// A pose of the query in the map that stands for all that put it about there.
struct PlaceHypothesis {
  std::size_t report = 0;              ///< position among the reports
  const RelativePose* pose = nullptr;  ///< of that report, its best or another one
  std::optional<EntryInfo> info;       ///< of the candidate
  double support = 0.0;                ///< by the candidate's graph, then by its place as well
};

/// Whether two hypotheses put the query in one place, looking the same way.
template <typename Hypothesis>
bool same_place(const Hypothesis& a, KeyframeId a_id, const Hypothesis& b, KeyframeId b_id,
                const PlaceOptions& options) {
  const auto apart = [&](const auto& between) {
    return between.translation().norm() > options.distinct_translation ||
           Eigen::AngleAxisd(between.linear()).angle() > options.distinct_rotation;
  };
  const auto& T_a = a.pose->T_candidate_query;
  const auto& T_b = b.pose->T_candidate_query;
  if (a_id == b_id) return !apart(T_a.inverse() * T_b);
  if (a.info && b.info && a.info->T_world_camera && b.info->T_world_camera) {
    return !apart((*a.info->T_world_camera * T_a).inverse() * (*b.info->T_world_camera * T_b));
  }
  if (a.info && b.info && a.info->session != b.info->session) return false;
  const std::uint64_t low = std::min(value(a_id), value(b_id));
  return std::max(value(a_id), value(b_id)) - low < options.min_id_gap;
}

/// The best poses of all candidates, each in another place, best first.
template <typename Bag, typename Reports>
std::vector<PlaceHypothesis> place_hypotheses(const Bag& bag, const Reports& reports,
                                              const PlaceOptions& options) {
  std::vector<PlaceHypothesis> all;
  for (std::size_t i = 0; i < reports.size(); ++i) {
    const auto offer = [&](const RelativePose& pose) {
      if (!pose.degenerate && pose.score() >= options.min_score) {
        all.push_back({i, &pose, std::nullopt, pose.support()});
      }
    };
    if (reports[i].pose) offer(*reports[i].pose);
    for (const RelativePose& other : reports[i].other_poses) offer(other);
  }
  std::sort(all.begin(), all.end(), [&](const PlaceHypothesis& a, const PlaceHypothesis& b) {
    const double a_score = a.pose->score(), b_score = b.pose->score();
    if (a_score != b_score) return a_score > b_score;
    return reports[a.report].id < reports[b.report].id;
  });
  std::vector<PlaceHypothesis> kept;
  for (PlaceHypothesis& hypothesis : all) {
    if (kept.size() == options.max_rivals) break;
    const KeyframeId id = reports[hypothesis.report].id;
    hypothesis.info = stored_info(bag, id, 0);
    const bool known = std::any_of(kept.begin(), kept.end(), [&](const PlaceHypothesis& better) {
      return same_place(better, reports[better.report].id, hypothesis, id, options);
    });
    if (!known) kept.push_back(std::move(hypothesis));
  }
  return kept;
}

/// The pose of one hypothesis in the frame of another one's candidate, where the two share a frame.
template <typename Reports>
std::optional<Eigen::Isometry3d> seen_from(const PlaceHypothesis& frame,
                                           const PlaceHypothesis& other, const Reports& reports) {
  const Eigen::Isometry3d& T_other = other.pose->T_candidate_query;
  if (reports[frame.report].id == reports[other.report].id) return T_other;
  const bool posed =
      frame.info && other.info && frame.info->T_world_camera && other.info->T_world_camera;
  if (!posed) return std::nullopt;
  return frame.info->T_world_camera->inverse() * *other.info->T_world_camera * T_other;
}

/// What a place counts for that speaks less for a pose than the best of `repeats` + 1 key frames
/// which all see the same: of so many that err apart the best one is the luckiest, as much as
/// the map is dense.
inline double share_among_repeats(std::size_t repeats) noexcept {
  const auto n = static_cast<double>(std::max<std::size_t>(repeats, 1));
  return n / (n + 1.0);
}

/// Judges the best poses again by the places around them, and names the rivals among all. Writes
/// into the reports whose own pose was judged.
template <typename Bag, typename Reports>
void judge_places(const Bag& bag, const typename Bag::Graph& query,
                  const RecognitionOptions& options, Reports& reports) {
  auto hypotheses = place_hypotheses(bag, reports, options.place);
  const std::size_t judged = std::min(options.place.max_hypotheses, hypotheses.size());
  for (std::size_t i = 0; i < judged; ++i) {
    PlaceHypothesis& hypothesis = hypotheses[i];
    auto& report = reports[hypothesis.report];
    const auto candidate = stored_graph(bag, report.id, 0);
    const double scale = hypothesis.pose->scale;
    const Rescaled<typename Bag::Graph> in_metres(query, scale);
    const auto place =
        place_graph(bag, report.id, *candidate, *in_metres, hypothesis.pose->T_candidate_query,
                    options.retrieval, options.matching, options.place);
    const auto pose =
        judge_pose(place, query, hypothesis.pose->T_candidate_query, options.matching, scale);
    const double least = hypothesis.support - options.place.max_contradiction;
    const double place_support = pose ? std::max(least, pose->support()) : least;
    double share = report.place_share;
    if (hypothesis.info && place_support < hypothesis.support) {
      const std::size_t repeats =
          repeated_views(bag, report.id, *hypothesis.info, query, options.retrieval, options.place);
      share = share_among_repeats(std::min(repeats, options.place.max_keyframes));
    }
    hypothesis.support = (1.0 - share) * hypothesis.support + share * place_support;
    if (hypothesis.pose != &*report.pose) continue;
    report.place_support = place_support;
    report.place_share = share;
    // The same pose, seen by more, or more exactly: not another one.
    if (pose && pose->inliers.size() >= report.pose->inliers.size() &&
        pose->rms <= report.pose->rms && within_uncertainty(*report.pose, *pose)) {
      report.place_pose = RefinedPose{pose->T_candidate_query, pose->covariance};
      report.place_scale = pose->scale;
      report.place_scale_deviation = pose->scale_deviation;
      report.place_scale_covariance = pose->scale_covariance;
    }
  }
  for (std::size_t i = 0; i < judged; ++i) {
    const PlaceHypothesis& hypothesis = hypotheses[i];
    auto& report = reports[hypothesis.report];
    if (hypothesis.pose != &*report.pose) continue;
    for (const PlaceHypothesis& other : hypotheses) {
      if (other.report == hypothesis.report) continue;  // told by `other_poses`
      const std::size_t elsewhere = objects_put_elsewhere(query, *hypothesis.pose, *other.pose,
                                                          seen_from(hypothesis, other, reports));
      const double lead = lead_to_ask(elsewhere, other.support, options.decision);
      if (other.support <= hypothesis.support - lead) continue;
      if (report.rival && report.rival->support >= other.support) continue;
      report.rival = rival_place(reports[other.report].id, other, lead);
    }
  }
}

}  // namespace detail
}  // namespace v0
}  // namespace topobag
