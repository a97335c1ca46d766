// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include <topobag/bag/detail/present_view.hpp>
#include <topobag/recognition/detail/alignment_votes.hpp>
#include <topobag/recognition/detail/stored_entry.hpp>
#include <topobag/recognition/map_alignment.hpp>
#include <topobag/recognition/relocalizer.hpp>

namespace topobag {
inline namespace v0 {

namespace detail {

/// Takes what a recognition says of a key frame of map b: each match that passes by itself is a
/// vote, also one that is not believed because another place fits as well. Which of them is true
/// the whole map says.
template <typename Bag>
void add_votes(std::vector<AlignmentVote>& votes, const Bag& a, const Recognition& recognition,
               KeyframeId id, const Eigen::Isometry3d& T_b_camera) {
  for (const CandidateReport& report : recognition.candidates) {
    const bool one = report.verdict == Verdict::accepted || report.verdict == Verdict::rivalled ||
                     report.verdict == Verdict::not_best;
    if (!one && report.verdict != Verdict::ambiguous) continue;
    const auto info = stored_info(a, report.id, 0);
    if (!info || !info->T_world_camera) continue;
    const auto vote = [&](const RelativePose& pose) {
      if (pose.degenerate) return;
      const PoseWithCovariance<> T_a_camera =
          PoseWithCovariance<>{*info->T_world_camera} * pose.with_covariance();
      const PoseWithCovariance<> T_camera_b{T_b_camera.inverse()};
      votes.push_back({id, T_b_camera, T_a_camera.T, T_a_camera * T_camera_b});
    };
    vote(*report.pose);
    if (one) continue;
    for (const RelativePose& other : report.other_poses) vote(other);
  }
}

}  // namespace detail

/// How map b lies in map a, which were made apart: key frames of b are looked up in a, and the
/// verified matches have to agree on one motion between the two worlds.
///
/// Refused when too few agree, and when another motion has more than a share of them: two maps of
/// buildings with equal rooms tell no more. Key frames without a pose in the world say nothing.
/// Deterministic. Cost: a query for each key frame that is asked.
///
///     if (const MapAlignment alignment = align_maps(a, b)) {
///       a.merge(b, {next_session, alignment.T_a_b->T});
///     }
/// @param a  a bag to look up in
/// @param b  a bag with `for_each`
template <typename A, typename B>
MapAlignment align_maps(const A& a, const B& b, const AlignOptions& options = {}) {
  using Graph = typename A::Graph;
  const auto present_a = detail::present_view(a, 0);
  std::vector<std::pair<KeyframeId, Eigen::Isometry3d>> usable;
  b.for_each([&](KeyframeId id, const EntryInfo& info, const Graph& graph) {
    if (info.T_world_camera && graph.is_matchable()) usable.emplace_back(id, *info.T_world_camera);
  });
  MapAlignment alignment;
  bool a_has_poses = false;
  present_a->for_each([&](KeyframeId, const EntryInfo& info, const Graph& graph) {
    a_has_poses = a_has_poses || (info.T_world_camera && graph.is_matchable());
  });
  if (usable.empty() || !a_has_poses) return alignment;

  const Relocalizer relocalizer(*present_a, options.recognition);
  std::vector<detail::AlignmentVote> votes;
  alignment.asked = std::min(options.max_keyframes, usable.size());
  for (std::size_t i = 0; i < alignment.asked; ++i) {
    const auto& [id, T_b_camera] = usable[i * usable.size() / alignment.asked];
    const auto graph = b.find(id);
    if (graph) detail::add_votes(votes, *present_a, relocalizer.localize(*graph), id, T_b_camera);
    if (options.on_query) options.on_query();
  }
  alignment.matched = detail::voters(votes);
  std::vector<detail::AlignmentVote> best = detail::consensus(votes, options);
  alignment.agreeing = detail::voters(best);
  alignment.verdict = AlignmentVerdict::too_few;
  if (best.empty() || alignment.agreeing < options.min_matches) return alignment;
  const PoseWithCovariance<> mean = detail::mean_alignment(best);
  alignment.places = detail::places_of_voters(best);

  std::vector<detail::AlignmentVote> others;
  for (const detail::AlignmentVote& vote : votes) {
    if (!detail::agrees(mean, vote, options)) others.push_back(vote);
  }
  alignment.rivalling = detail::voters(detail::consensus(others, options));
  const bool fits_as_well = static_cast<double>(alignment.rivalling) >
                            options.max_rival_share * static_cast<double>(alignment.agreeing);
  alignment.verdict = fits_as_well ? AlignmentVerdict::ambiguous : AlignmentVerdict::aligned;
  if (!fits_as_well) alignment.T_a_b = mean;
  return alignment;
}

}  // namespace v0
}  // namespace topobag
