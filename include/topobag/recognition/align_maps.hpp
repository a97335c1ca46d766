// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include <topobag/bag/detail/present_view.hpp>
#include <topobag/recognition/detail/alignment_motion.hpp>
#include <topobag/recognition/detail/alignment_votes.hpp>
#include <topobag/recognition/detail/stored_entry.hpp>
#include <topobag/recognition/map_alignment.hpp>
#include <topobag/recognition/relocalizer.hpp>

namespace topobag {
inline namespace v0 {

namespace detail {

/// Takes what a recognition says of a key frame of map b: each match that passes by itself is a
/// vote, also one that is not believed because another place fits as well, or its own speaks
/// against it. Which of them is true the whole map says.
template <typename Motion, typename Bag>
void add_votes(std::vector<AlignmentVote<Motion>>& votes, const Bag& a,
               const Recognition& recognition, KeyframeId id, const Eigen::Isometry3d& T_b_camera) {
  for (const CandidateReport& report : recognition.candidates) {
    const bool one = is_verified(report.verdict) || report.verdict == Verdict::rivalled ||
                     report.judged_by.has_value();
    if (!one && report.verdict != Verdict::ambiguous) continue;
    const auto info = stored_info(a, report.id, 0);
    if (!info || !info->T_world_camera) continue;
    const auto vote = [&](const RelativePose& pose) {
      if (pose.degenerate) return;
      Motion a_candidate, camera_b;
      a_candidate.T = *info->T_world_camera;
      camera_b.T = T_b_camera.inverse();
      const Motion a_camera = a_candidate * motion_of<Motion>(pose);
      votes.push_back({id, T_b_camera, a_camera.T, a_camera * camera_b});
    };
    vote(*report.pose);
    if (one) continue;
    for (const RelativePose& other : report.other_poses) vote(other);
  }
}

inline void set_motion(MapAlignment& alignment, const PoseWithCovariance<>& T_a_b) {
  alignment.T_a_b = T_a_b;
}
inline void set_motion(MapAlignment& alignment, const Sim3WithCovariance& a_b) {
  const Sim3WithCovariance::Matrix7 covariance = a_b.of_pose_and_scale();
  alignment.T_a_b = PoseWithCovariance<>{a_b.T, covariance.topLeftCorner<6, 6>()};
  alignment.scale = a_b.scale;
  alignment.scale_deviation = a_b.scale * std::sqrt(covariance(6, 6));
  alignment.scale_covariance = covariance.topRightCorner<6, 1>();
}

/// How many of map b's cameras stand, by an alignment, where one of a's did, and look the same way.
/// O(cameras of a · cameras of b).
template <typename Motion, typename Cameras>
std::size_t revisiting_cameras(const Motion& a_b, const Cameras& of_a, const Cameras& of_b,
                               const PlaceOptions& place) {
  const auto revisits = [&](const auto& T_b_camera) {
    const auto T_a_camera = camera_in(a_b, T_b_camera);
    return std::any_of(of_a.begin(), of_a.end(), [&](const auto& T_a_other) {
      if (!((T_a_other.translation() - T_a_camera.translation()).norm() <=
            place.distinct_translation))
        return false;
      const auto between = (T_a_other.linear().transpose() * T_a_camera.linear()).eval();
      return Eigen::AngleAxisd(between).angle() <= place.distinct_rotation;
    });
  };
  return static_cast<std::size_t>(std::count_if(of_b.begin(), of_b.end(), revisits));
}

/// Asks map b's key frames in a, and on what motion the answers agree.
/// @param cameras_a  of all key frames that a match could be of, as they stand in a
/// @param usable     of b, with their poses
/// @param alignment  is filled in
template <typename Motion, typename View, typename B>
void align_by_votes(const View& a, const std::vector<Eigen::Isometry3d>& cameras_a, const B& b,
                    const std::vector<std::pair<KeyframeId, Eigen::Isometry3d>>& usable,
                    const AlignOptions& options, MapAlignment& alignment) {
  const Relocalizer relocalizer(a, options.recognition);
  std::vector<AlignmentVote<Motion>> votes;
  std::vector<Eigen::Isometry3d> cameras_b;
  alignment.asked = std::min(options.max_keyframes, usable.size());
  for (std::size_t i = 0; i < alignment.asked; ++i) {
    const auto& [id, T_b_camera] = usable[i * usable.size() / alignment.asked];
    cameras_b.push_back(T_b_camera);
    const auto graph = b.find(id);
    if (graph) add_votes(votes, a, relocalizer.localize(*graph), id, T_b_camera);
    if (options.on_query) options.on_query();
  }
  alignment.matched = voters(votes);
  const auto best = consensus(votes, options);
  alignment.agreeing = voters(best);
  alignment.verdict = AlignmentVerdict::too_few;
  if (best.empty() || alignment.agreeing < options.min_matches) return;
  const Motion mean = mean_alignment(best);
  alignment.places = places_of_voters(best, scale_of(mean));

  std::vector<AlignmentVote<Motion>> others;
  for (const auto& vote : votes) {
    if (!agrees(mean, vote, options)) others.push_back(vote);
  }
  alignment.rivalling = voters(consensus(others, options));
  const bool fits_as_well = static_cast<double>(alignment.rivalling) >
                            options.max_rival_share * static_cast<double>(alignment.agreeing);
  alignment.revisiting = revisiting_cameras(mean, cameras_a, cameras_b, options.recognition.place);
  const bool contradicted = static_cast<double>(alignment.agreeing) <
                            options.min_revisit_share * static_cast<double>(alignment.revisiting);
  alignment.verdict = fits_as_well   ? AlignmentVerdict::ambiguous
                      : contradicted ? AlignmentVerdict::contradicted
                                     : AlignmentVerdict::aligned;
  if (alignment.verdict == AlignmentVerdict::aligned) set_motion(alignment, mean);
}

}  // namespace detail

/// How map b lies in map a, which were made apart: key frames of b are looked up in a, and the
/// verified matches have to agree on one motion between the two worlds.
///
/// Refused when too few agree, when another motion has more than a share of them, as of two maps of
/// buildings with equal rooms, and when it is contradicted: by it many of b's cameras stand where
/// a's did, and hardly one recognises the place, as when two desks are alike in one corner. Key
/// frames without a pose in the world say nothing. Deterministic. Cost: a query for each key frame
/// that is asked, O(matches²), and O(asked · key frames of a).
///
/// Where b's unit is not known (`AlignOptions::recognition.matching.scale`), each match is a
/// Sim(3), and they have to agree on the scale as well; how far b's cameras stand apart then tells
/// it more exactly than any one match. (Umeyama, PAMI 1991, over matches with their covariances.)
///
///     if (const MapAlignment alignment = align_maps(a, b)) {
///       a.merge(b, alignment.merge_options(next_session));
///     }
/// @param a  a bag to query, with `for_each`; or one whose `view()` has both
/// @param b  a bag with `for_each` and `find`
template <typename A, typename B>
MapAlignment align_maps(const A& a, const B& b, const AlignOptions& options = {}) {
  using Graph = typename A::Graph;
  const auto present_a = detail::present_view(a, 0);
  std::vector<std::pair<KeyframeId, Eigen::Isometry3d>> usable;
  b.for_each([&](KeyframeId id, const EntryInfo& info, const Graph& graph) {
    if (info.T_world_camera && graph.is_matchable()) usable.emplace_back(id, *info.T_world_camera);
  });
  MapAlignment alignment;
  std::vector<Eigen::Isometry3d> cameras_a;
  present_a->for_each([&](KeyframeId, const EntryInfo& info, const Graph& graph) {
    if (info.T_world_camera && graph.is_matchable()) cameras_a.push_back(*info.T_world_camera);
  });
  if (usable.empty() || cameras_a.empty()) return alignment;

  if (options.recognition.matching.scale) {
    detail::align_by_votes<detail::Sim3WithCovariance>(*present_a, cameras_a, b, usable, options,
                                                       alignment);
  } else {
    detail::align_by_votes<PoseWithCovariance<>>(*present_a, cameras_a, b, usable, options,
                                                 alignment);
  }
  return alignment;
}

}  // namespace v0
}  // namespace topobag
