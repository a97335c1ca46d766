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
#include <topobag/recognition/detail/keyframe_motion.hpp>
#include <topobag/recognition/detail/pose_rivals.hpp>
#include <topobag/recognition/detail/session_order.hpp>
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
  std::vector<std::size_t> others{};   ///< reports whose own pose is of that place, and no better
};

/// The pose of one hypothesis in the frame of another one's candidate, where it is known how the
/// two key frames stand to each other.
template <typename Bag, typename Reports>
std::optional<Eigen::Isometry3d> seen_from(KeyframeMotion<Bag>& motion,
                                           const PlaceHypothesis& frame,
                                           const PlaceHypothesis& other, const Reports& reports) {
  const auto T_frame_other = motion.between({reports[frame.report].id, frame.info},
                                            {reports[other.report].id, other.info});
  if (!T_frame_other) return std::nullopt;
  return *T_frame_other * other.pose->T_candidate_query;
}

/// Whether fewer than `gap` steps lead from one key frame of a session to the other; by their ids
/// where nothing is known of them.
template <typename Bag>
bool are_close_in_session(const Bag& bag, const KnownEntry& a, const KnownEntry& b,
                          std::uint64_t gap) {
  const auto [first, last] = std::minmax(a.id, b.id);
  if (!a.info || !b.info || gap == 0) return value(last) - value(first) < gap;
  if (a.info->session != b.info->session) return false;
  const auto next = next_of_session(bag, first, *a.info, true, gap - 1);
  return std::find(next.begin(), next.end(), last) != next.end();
}

/// Whether two hypotheses put the query in one place, looking the same way. Where nothing tells how
/// their key frames stand to each other: whether these are close in their session.
template <typename Bag, typename Reports>
bool same_place(const Bag& bag, KeyframeMotion<Bag>& motion, const PlaceHypothesis& a,
                const PlaceHypothesis& b, const Reports& reports, const PlaceOptions& options) {
  if (const auto T_a_query = seen_from(motion, a, b, reports)) {
    return options.is_one_place(a.pose->T_candidate_query.inverse() * *T_a_query);
  }
  return are_close_in_session(bag, {reports[a.report].id, a.info}, {reports[b.report].id, b.info},
                              options.min_id_gap);
}

/// The best poses of all candidates, each in another place, best first.
template <typename Bag, typename Reports>
std::vector<PlaceHypothesis> place_hypotheses(const Bag& bag, KeyframeMotion<Bag>& motion,
                                              const Reports& reports, const PlaceOptions& options) {
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
    if (a.report != b.report) return reports[a.report].id < reports[b.report].id;
    return a.pose == &*reports[a.report].pose && a.pose != b.pose;
  });
  std::vector<PlaceHypothesis> kept;
  for (PlaceHypothesis& hypothesis : all) {
    if (kept.size() == options.max_rivals) break;
    hypothesis.info = stored_info(bag, reports[hypothesis.report].id, 0);
    const auto known = std::find_if(kept.begin(), kept.end(), [&](const PlaceHypothesis& better) {
      return same_place(bag, motion, better, hypothesis, reports, options);
    });
    if (known == kept.end()) {
      kept.push_back(std::move(hypothesis));
    } else if (hypothesis.pose == &*reports[hypothesis.report].pose) {
      known->others.push_back(hypothesis.report);
    }
  }
  return kept;
}

/// What a place counts for that speaks less for a pose than the best of `repeats` + 1 key frames
/// which all see the same: of so many that err apart the best one is the luckiest, as much as
/// the map is dense.
inline double share_among_repeats(std::size_t repeats) noexcept {
  const auto n = static_cast<double>(std::max<std::size_t>(repeats, 1));
  return n / (n + 1.0);
}

/// Judges the best poses again by the places around them, and names the rivals among all. Writes
/// into the reports whose own pose was judged, and into the others by which of these they are.
template <typename Bag, typename Reports>
void judge_places(const Bag& bag, const typename Bag::Graph& query,
                  const RecognitionOptions& options, Reports& reports) {
  KeyframeMotion<Bag> motion(bag, options);
  auto hypotheses = place_hypotheses(bag, motion, reports, options.place);
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
      const std::size_t elsewhere = objects_put_elsewhere(
          query, *hypothesis.pose, *other.pose, seen_from(motion, hypothesis, other, reports));
      const double lead = lead_to_ask(elsewhere, other.support, options.decision);
      if (other.support <= hypothesis.support - lead) continue;
      if (report.rival && report.rival->support >= other.support) continue;
      report.rival = rival_place(reports[other.report].id, other, lead);
    }
  }
  if (judged == 0) return;
  for (std::size_t i = 0; i < judged; ++i) {
    for (const std::size_t other : hypotheses[i].others) {
      reports[other].judged_by = reports[hypotheses[i].report].id;
    }
  }
  // Of other places than those that were judged: the best of these is a better one elsewhere.
  const PlaceHypothesis& best = hypotheses.front();
  for (auto& report : reports) {
    if (report.place_support || report.judged_by) continue;
    report.judged_by = reports[best.report].id;
    report.rival = rival_place(*report.judged_by, best, 0.0);
  }
}

}  // namespace detail
}  // namespace v0
}  // namespace topobag
